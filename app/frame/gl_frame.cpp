#include "app/frame/gl_frame.h"

#include <algorithm>

namespace kd {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds idle_after{5}, awake_after{500};

/// A pass that took no time did not run.
FrameTime time_of(const GlFrameReport& report) {
    FrameTime time{.total_ms = report.total_ms, .wall_ms = report.wall_ms, .shaded_pixels = report.shaded_pixels};
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (report.pass_ms[pass] > 0) time.pass_ms[pass] = report.pass_ms[pass];
    return time;
}

}  // namespace

DispatchPlan& GlFrameDrawer::plan_for(GlTraceConfig config) {
    config.trace = at_first_sample(config.trace);
    const auto known = std::ranges::find(plans_, config, &Planned::config);
    if (known != plans_.end()) return known->plan;
    if (plans_.size() == most_plans) plans_.erase(plans_.begin());
    plans_.push_back({config, DispatchPlan(tile_ms_)});
    return plans_.back().plan;
}

FrameTime GlFrameDrawer::draw(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera, int width,
                              int height, const std::stop_token& stop, const std::function<void(float)>& progress) {
    DispatchPlan& plan = plan_for(config);
    FrameTime time;
    const std::int64_t pixels = std::int64_t(width) * height;
    for (std::int64_t done = 0; done < pixels;) {
        if (stop.stop_requested()) {
            time.complete = false;
            break;
        }
        const Tile tile = plan.next(done, width, height);
        const GlFrameReport report = tracer.draw(config, camera, width, height, tile);
        plan.learn(report.total_ms, tile);
        clock_ = report.clock;
        time.add(time_of(report));
        done += std::int64_t(tile.x1 - tile.x0) * (tile.y1 - tile.y0);
        if (progress) progress(float(double(done) / double(pixels)));
    }
    drawn_ = Clock::now();
    return time;
}

FrameTime GlFrameDrawer::draw_tiles(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera,
                                    int width, int height, std::span<const Tile> tiles, const std::stop_token& stop,
                                    const std::function<void(float)>& progress) {
    FrameTime time;
    for (std::size_t i = 0; i < tiles.size() && time.complete; ++i) {
        time.add(time_of(tracer.draw(config, camera, width, height, tiles[i])));
        time.complete = !stop.stop_requested();
        if (progress) progress(float(i + 1) / float(tiles.size()));
    }
    drawn_ = Clock::now();
    return time;
}

int GlFrameDrawer::wake(GlTracer& tracer, const GlTraceConfig& config, const PinholeCamera& camera, int width,
                        int height, const std::stop_token& stop) {
    const Clock::time_point begun = Clock::now();
    if (begun - drawn_ < idle_after) return 0;
    int frames = 0;
    for (; !stop.stop_requested() && (frames == 0 || Clock::now() - begun < awake_after); ++frames)
        (void)draw(tracer, config, camera, width, height, stop, {});
    return frames;
}

}  // namespace kd
