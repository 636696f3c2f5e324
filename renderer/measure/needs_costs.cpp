#include "renderer/measure/needs_costs.h"

#include <string>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/memory_plan.h"

namespace kd {

namespace {

/// The needs without a feature that is needed: no such frame is right, but its memory can be counted.
SceneNeeds stripped(SceneNeeds needs, const FeatureInfo& feature) {
    if (!(needs.*feature.in_use)) return needs;
    needs.*feature.in_use = false;
    if (feature.id == Feature::reflections) needs.bounces = 0;
    if (feature.id == Feature::later_bounces) needs.bounces = 1;
    return needs;
}

}  // namespace

std::vector<Feature> timed_features(const SceneFacts& facts, TraceConfig config, bool on_cpu) {
    config.counters = false;
    return removable(facts, config, on_cpu);
}

std::vector<FeatureTime> time_features(const std::vector<Feature>& features, const ForcedFrame& frame, int rounds,
                                       const std::function<bool(float)>& progress) {
    struct Stopped {};
    const int runs = rounds * int(features.size() + 1);
    int done = 0;
    const auto contestant = [&](std::string_view name, FeatureSet forced) {
        return Contestant{std::string(name), [&, forced] {
                              if (progress && !progress(float(done++) / float(runs))) throw Stopped{};
                              (void)frame(forced);
                              return frame(forced);
                          }};
    };
    std::vector<Contestant> contestants{contestant("without", {})};
    for (const Feature feature : features) contestants.push_back(contestant(info(feature).name, feature));
    std::vector<TimedRounds> timed;
    try {
        timed = time_in_turn(contestants, {.warmup = 0, .rounds = rounds});
    } catch (const Stopped&) {
        return {};
    }
    const std::vector<double> without = timed.front().ms();
    std::vector<FeatureTime> times;
    for (std::size_t i = 0; i < features.size(); ++i) {
        std::vector<double> saved = timed[i + 1].ms();
        for (std::size_t round = 0; round < saved.size(); ++round) saved[round] -= without[round];
        times.push_back(
            {features[i], timed.front().total(), median_interval(std::move(saved)), timed.front().clock_discrepancy()});
    }
    return times;
}

std::int64_t feature_bytes(Feature feature, const FlatScene& scene, const KdTree& tree, const SceneFacts& facts,
                           const TraceConfig& config, std::optional<CpuMode> cpu, int width, int height) {
    TraceConfig with = config, without = config;
    with.forced.set(feature, true);
    without.forced.set(feature, false);
    const auto bytes = [&](const SceneNeeds& needs) {
        return cpu ? cpu_table_bytes(tree, needs, mode_in_force(*cpu, config, needs.masks))
                   : planned_memory(scene, tree, needs, width, height).total();
    };
    return bytes(scene_needs(facts, with)) - bytes(stripped(scene_needs(facts, without), info(feature)));
}

}  // namespace kd
