// Whole frames by OpenGL, in tiles.
#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/frame/frame_time.h"
#include "renderer/gl/dispatch_plan.h"
#include "renderer/gl/gl_tracer.h"

namespace kd {

/// Draws frames in tiles of about `tile_ms` milliseconds, between which work can be stopped.
class GlFrameDrawer {
  public:
    explicit GlFrameDrawer(double tile_ms) : tile_ms_(tile_ms) {}

    /// The frame stays in the tracer's targets; incomplete where stopped.
    FrameTime draw(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera, int width, int height,
                   const std::stop_token& stop, const std::function<void(float)>& progress);
    /// The same of some tiles only, one draw each.
    FrameTime draw_tiles(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera, int width,
                         int height, std::span<const Tile> tiles, const std::stop_token& stop,
                         const std::function<void(float)>& progress);
    /// Before a frame that is timed on hardware: where the GPU has idled, draws frames that do not count until its
    /// clocks are up again. They fall within milliseconds (H100: from 1980 to 345 MHz), and the first frame after a
    /// pause takes as many times longer. Returns how many frames it drew.
    int wake(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera, int width, int height,
             const std::stop_token& stop);
    /// Another scene: its speed is not known.
    void forget_speed() { plans_.clear(); }
    /// What the times were read from.
    [[nodiscard]] const std::string& clock() const { return clock_; }

  private:
    /// Configurations that take turns keep what is known of their speed.
    struct Planned {
        GlTraceConfig config;
        DispatchPlan plan;
    };
    static constexpr std::size_t most_plans = 16;

    DispatchPlan& plan_for(GlTraceConfig config);

    double tile_ms_;
    std::vector<Planned> plans_;
    std::string clock_ = "not read yet";
    std::chrono::steady_clock::time_point drawn_;  // when the last frame ended
};

}  // namespace kd
