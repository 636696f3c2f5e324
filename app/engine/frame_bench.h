// Something that is measured behind the window of every frame that stays, while nobody works.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/engine/background.h"
#include "renderer/trace/frame.h"

namespace kd {

struct TracedFrame;  // app/engine/state.h

/// What is known of the newest measurement, whatever it measures.
struct FrameBenchState {
    bool active = false;
    bool outdated = true;  // the result is of another frame or other rays than those shown, or there is none
    float fraction = 0;    // 0..1
    std::string error;     // why there is no result
};

/// All member functions are called on the thread that owns `state`.
class FrameBench {
  public:
    /// Called in the background; what it returns is called on the owner's thread and takes the result over. Nothing
    /// where stopped.
    using Work =
        std::function<std::function<void()>(const std::stop_token&, const std::function<void(float)>& progress)>;

    /// Results go through `mailbox` into `state`; both must outlive this.
    FrameBench(Mailbox& mailbox, FrameBenchState& state) : state_(state), run_(mailbox) {}

    /// Whether the result, or the one that is on its way, is of these rays of this frame; tells the state.
    bool is_of(const TracedFrame& traced, Pass rays);
    /// Measures them in the background; what ran before is dropped. `what` is named where memory runs out.
    void measure(const TracedFrame& traced, Pass rays, const std::string& what, Work work);
    void cancel();

  private:
    FrameBenchState& state_;
    std::weak_ptr<const Frame> frame_;  // that the result is of, or shall be
    Pass rays_ = Pass::rt_prim;
    bool measured_ = false;  // there is a result of it
    BackgroundRun run_;      // last: joined before what its jobs use goes
};

}  // namespace kd
