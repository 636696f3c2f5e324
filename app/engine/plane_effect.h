// What planes put by hand do to the picture's walks: the frame with them against the same one without.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/engine/world.h"
#include "app/session.h"
#include "renderer/trace/counters.h"

namespace kd {

struct TracedFrame;  // app/engine/state.h

/// What the walks of a whole frame came to.
struct FrameWalks {
    /// Sums over the pixels that have such rays, of which `rays` is the number.
    std::array<CounterTotals, pass_count> totals;
    double sah_cost = 0;  // of the tree, in traversal steps
};

/// What a frame's walks came to, by kind of rays.
[[nodiscard]] std::array<CounterTotals, pass_count> walk_totals(const Frame& frame);

struct PlaneEffect {
    bool planes = false;                // there are planes by hand
    std::optional<FrameWalks> now;      // of the newest whole frame, where it answers what is asked for
    std::optional<FrameWalks> without;  // of a frame that differs in nothing but that it has no planes by hand
};

/// Keeps what frames without planes by hand came to. They are compared only where scene, camera, size, traversal and
/// the constants of the builder are the same; a tracer does not matter, for counters are the same on all.
class PlaneBook {
  public:
    explicit PlaneBook(PlaneEffect& effect) : effect_(effect) {}

    /// A whole frame of `session`, whose camera is the one in use.
    void note(const TracedFrame& traced, const Session& session);
    /// What is asked for now.
    void turn_to(const Session& session, const std::shared_ptr<const LoadedScene>& loaded);

  private:
    struct Page {
        Session session;  // all of it that counters depend on
        std::weak_ptr<const LoadedScene> loaded;
        FrameWalks walks;
    };
    [[nodiscard]] const Page* find(const Session& key, const std::shared_ptr<const LoadedScene>& loaded) const;

    static constexpr std::size_t most_pages = 32;

    PlaneEffect& effect_;
    std::vector<Page> without_;  // oldest first
    std::optional<Page> now_;    // with its planes
};

}  // namespace kd
