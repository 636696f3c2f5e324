// Efficiency against width behind the window: measured anew for every frame that stays, while nobody works.
#pragma once

#include <memory>
#include <string>

#include "app/engine/background.h"
#include "renderer/measure/frame_walks.h"

namespace kd {

struct TracedFrame;  // app/engine/state.h

struct WidthState {
    bool active = false;
    bool outdated = true;  // the report is of another frame or other rays than those shown
    float fraction = 0;    // 0..1
    std::shared_ptr<const DivergenceReport> report;
    std::string error;  // why there is none
};

/// All member functions are called on the thread that owns `state`.
class WidthBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    WidthBench(Mailbox& mailbox, WidthState& state) : state_(state), run_(mailbox) {}

    /// Whether the report, or the one that is on its way, is of these rays of this frame; tells the state.
    bool is_of(const TracedFrame& traced, Pass rays);
    /// Measures them in the background; what ran before is dropped.
    void measure(const TracedFrame& traced, Pass rays, int threads);
    void cancel();

  private:
    WidthState& state_;
    std::weak_ptr<const Frame> frame_;  // that the report is of, or shall be
    Pass rays_ = Pass::rt_prim;
    BackgroundRun run_;  // last: joined before what its jobs use goes
};

}  // namespace kd
