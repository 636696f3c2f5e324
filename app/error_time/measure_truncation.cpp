// P5 of one scene.
#include <algorithm>
#include <fmt/format.h>
#include <ranges>

#include "app/cli/command.h"
#include "app/error_time/frame_reports.h"
#include "app/frame/counted_frame.h"
#include "renderer/scene/needs_sizes.h"
#include "renderer/trace/counters.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

constexpr int frames_of_point = 9;  // judged, counted, warmed up, and six rounds

WalkedFrame walked(const Frame& frame) {
    WalkedFrame found{count_unfinished(frame).pixels, 0};
    for (const RayLayer& layer : frame.layers)
        for (const RayCounters& counters : layer.counters.pixels)
            found.most_steps = std::max(found.most_steps, lane_steps(counters));
    return found;
}

bool sees_reflections(const Frame& frame) {
    return std::ranges::any_of(std::views::iota(std::size_t(0), frame.colour.pixels.size()),
                               [&](std::size_t pixel) { return ray_traced(frame, Pass::rt_refl, pixel); });
}

class Truncated {
  public:
    Truncated(const FrameReportTask& task, SceneErrorTime& result) : task_(task), result_(result) {
        config_ = task.opened.session.trace;
        config_.sampling.sample = -1;
        config_.counters = false;
    }

    void measure() {
        const double begun = steady_seconds();
        TruncationTask truncation;
        const SceneFacts facts = scene_facts(task_.opened.scene, task_.tree);
        config_.reflection_depth = most_measured_bounces;
        truncation.deepest = countable_bounces(facts, config_);
        truncation.largest_reflectance = facts.largest_reflectance;
        if (const std::string why = no_reflections(truncation.deepest); !why.empty()) {
            result_.left_out.push_back({ErrorReport::p5, "reflection depth: " + why});
            truncation.deepest = 0;
        }
        truncation.budgets = task_.tree.nodes.size() > 1;
        if (!truncation.budgets)
            result_.left_out.push_back({ErrorReport::p5, "step budget: the tree is one leaf, so no walk has a step"});
        if (truncation.deepest == 0 && !truncation.budgets) return;
        truncation.config = config_;
        for (FrameMachine& machine : task_.machines)
            for (const Traversal traversal : task_.config.traversals) add_method(machine, traversal, truncation);
        side_ = fitting_side(truncation);
        truncation.width = truncation.height = side_;
        truncation.seconds = std::max(0.0, task_.seconds - (steady_seconds() - begun));
        result_.truncation = report_truncation(truncation, task_.progress, task_.stop);
        check();
    }

  private:
    void check() const {
        if (task_.stop.stop_requested()) throw Interrupted();
    }

    [[nodiscard]] PinholeCamera camera() const { return pinhole(task_.opened.scene.camera, side_, side_); }

    /// Why depths are left out, part of a sentence; empty where they are not.
    [[nodiscard]] std::string no_reflections(int bounces) const {
        if (bounces == 0) return "no surface is reflective";
        const auto frame = trace_counted(*task_.machines.front().tracer, config_, camera(), side_, side_, task_.stop);
        check();
        return sees_reflections(frame.value()) ? "" : "the camera sees no reflective surface";
    }

    void add_method(FrameMachine& machine, Traversal traversal, TruncationTask& truncation) const {
        FrameTracer& tracer = *machine.tracer;
        truncation.methods.push_back({machine.name, std::string(info(traversal).name), traversal, tracer.clock(),
                                      [&tracer, this](const TraceConfig& config, Image<Vec4>& colour) {
                                          tracer.prepare(config, side_, side_);
                                          const FrameTime time =
                                              tracer.trace(config, camera(), side_, side_, task_.stop);
                                          colour = tracer.frame(config).colour;
                                          return time.sample();
                                      },
                                      [&tracer, this](const TraceConfig& config) {
                                          const auto frame =
                                              trace_counted(tracer, config, camera(), side_, side_, task_.stop);
                                          check();
                                          return walked(frame.value());
                                      }});
    }

    /// The largest at which all points are predicted to be measured within the time; a second frame is asked, for the
    /// first may compile.
    [[nodiscard]] int fitting_side(const TruncationTask& truncation) const {
        Image<Vec4> colour;
        double ms = 0;
        for (const TruncationMethod& method : truncation.methods) {
            TraceConfig config = config_;
            config.traversal = method.walk;
            for (int i = 0; i < 2; ++i) {
                const double each = wall_ms([&] { (void)method.trace(config, colour); });
                if (i > 0) ms += each * frames_of_point * (truncation.deepest + 8);
            }
            check();
        }
        const std::initializer_list<int> sides{256, 192, 128, 96, 64, 48};
        for (const int side : sides)
            if (1e-3 * ms * side * side / (probe_side * probe_side) <= 0.8 * task_.seconds) return side;
        return 32;
    }

    const FrameReportTask& task_;
    SceneErrorTime& result_;
    TraceConfig config_;
    int side_ = probe_side;
};

}  // namespace

void measure_truncation(const FrameReportTask& task, SceneErrorTime& result) { Truncated(task, result).measure(); }

}  // namespace kd
