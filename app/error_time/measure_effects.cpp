// P6 of one scene.
#include <algorithm>
#include <fmt/format.h>

#include "app/cli/command.h"
#include "app/error_time/frame_reports.h"
#include "app/frame/sampled_frame.h"
#include "renderer/measure/double_path.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

/// Colours of a few samples are sums without rounding, so where nothing is drawn they do not vary at all.
constexpr int samples_of_a_look = 8;

struct NamedFeature {
    const char* name;
    Feature feature;
};
constexpr NamedFeature features_of_light[] = {
    {"soft shadows", Feature::soft_shadows}, {"gloss", Feature::gloss}, {"indirect light", Feature::indirect}};

class Effects {
  public:
    Effects(const FrameReportTask& task, SceneErrorTime& result)
        : task_(task), result_(result), boxes_(task.opened.scene.triangles), effects_{.scene = task.opened.scene,
                                                                                      .boxes = boxes_,
                                                                                      .config = {},
                                                                                      .plan = {},
                                                                                      .effects = {},
                                                                                      .methods = {}} {
        effects_.config = task.opened.session.trace;
        effects_.config.counters = false;
        if (!task.config.traversals.empty()) effects_.config.traversal = task.config.traversals.front();
        effects_.threads = task.opened.session.threads;
        effects_.seed = task.opened.session.seed;
    }

    void measure() {
        const double begun = steady_seconds();
        for (FrameMachine& machine : task_.machines) add_method(*machine.tracer, machine.name);
        effects_.effects = light_effects(effects_.scene, effects_.config);
        leave_out_absent();
        leave_out_unseen();
        if (effects_.effects.empty()) return;
        std::vector<EffectCost> costs;
        for (const LightEffect& effect : effects_.effects) costs.push_back(probe(effect));
        const double left = std::max(0.0, task_.seconds - (steady_seconds() - begun));
        effects_.plan = plan_effects(0.8 * left, costs, probe_side * probe_side);
        effects_.frame_seconds = 0.1 * left / double(effects_.effects.size());
        side_ = effects_.plan.width;
        result_.effects = report_effects(effects_, task_.progress, task_.stop);
        check();
    }

  private:
    void check() const {
        if (task_.stop.stop_requested()) throw Interrupted();
    }
    void leave_out(const std::string& why) { result_.left_out.push_back({ErrorReport::p6, why}); }

    [[nodiscard]] TraceConfig sampled(const LightEffect& effect) const {
        TraceConfig config = effects_.config;
        config.sampling = effect.sampling;
        config.sampling.sample = 0;
        config.sampling.seed = effects_.seed;
        return config;
    }

    [[nodiscard]] PinholeCamera camera() const { return effect_camera(effects_.scene, side_, side_); }

    void leave_out_absent() {
        const SceneFacts facts = scene_facts(effects_.scene, task_.tree);
        TraceConfig config = effects_.config;
        config.sampling = {.sample = 0};
        for (const auto& [name, feature] : features_of_light)
            if (const std::string why = why_left_out(feature, facts, config); !why.empty())
                leave_out(fmt::format("{}: {}", name, why));
    }

    /// What the scene has and no pixel shows; all of them together where that leaves one alone.
    void leave_out_unseen() {
        FrameTracer& tracer = *task_.machines.front().tracer;
        std::erase_if(effects_.effects, [&](const LightEffect& effect) {
            const SampledFrame look =
                trace_samples(tracer, sampled(effect), camera(), side_, side_, {samples_of_a_look, 0}, task_.stop);
            check();
            if (look.count.error > 0) return false;
            if (effect.sampling != Sampling{}) leave_out(effect.name + ": no pixel shows it");
            return true;
        });
        if (effects_.effects.size() == 2 && effects_.effects.back().sampling == Sampling{}) effects_.effects.pop_back();
    }

    void add_method(FrameTracer& tracer, const std::string& name) {
        effects_.methods.push_back({name, tracer.clock(),
                                    [&tracer, this](const TraceConfig& config, Image<Vec4>& colour) {
                                        const FrameTime time = tracer.trace(config, camera(), side_, side_, task_.stop);
                                        colour = tracer.frame(config).colour;
                                        return time.sample();
                                    },
                                    [&tracer, this](const TraceConfig& config, int samples, double error) {
                                        SampledFrame sampled = trace_samples(tracer, config, camera(), side_, side_,
                                                                             {samples, error}, task_.stop);
                                        return GatheredImage{std::move(sampled.frame.colour), sampled.time.total_ms,
                                                             sampled.count.average, sampled.count.average < samples};
                                    }});
    }

    /// Small frames, all that they take; the second of two, for the first may compile.
    [[nodiscard]] EffectCost probe(const LightEffect& effect) const {
        task_.progress(0, fmt::format("{}: a first look", effect.name));
        const TraceConfig config = sampled(effect);
        EffectCost cost;
        Image<Vec4> colour;
        for (const EffectMethod& method : effects_.methods) {
            double ms = 0;
            for (int i = 0; i < 2; ++i) ms = wall_ms([&] { (void)method.trace(config, colour); });
            cost.method_ms.push_back(ms);
            check();
        }
        cost.reference_ms = wall_ms([&] {
            (void)double_frame(effects_.scene, camera(), side_, side_, path_config(effects_.scene, config),
                               effects_.threads, task_.stop, &boxes_);
        });
        check();
        return cost;
    }

    const FrameReportTask& task_;
    SceneErrorTime& result_;
    TriangleBoxes boxes_;
    EffectTask effects_;
    int side_ = probe_side;
};

}  // namespace

void measure_effects(const FrameReportTask& task, SceneErrorTime& result) { Effects(task, result).measure(); }

}  // namespace kd
