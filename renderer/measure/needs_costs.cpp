#include "renderer/measure/needs_costs.h"

#include <optional>

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

std::vector<FeatureTime> time_features(const std::vector<Feature>& features, const ForcedFrame& frame, int rounds,
                                       const std::function<bool(float)>& progress) {
    std::vector<double> without;
    std::vector<std::vector<double>> saved(features.size());
    const int runs = rounds * int(features.size() + 1);
    int done = 0;
    const auto time = [&](FeatureSet forced) -> std::optional<double> {
        if (progress && !progress(float(done++) / float(runs))) return std::nullopt;
        (void)frame(forced);
        return frame(forced);
    };
    for (int round = 0; round < rounds; ++round) {
        const auto bare = time({});
        if (!bare) return {};
        without.push_back(*bare);
        for (std::size_t i = 0; i < features.size(); ++i) {
            const auto with = time(features[i]);
            if (!with) return {};
            saved[i].push_back(*with - *bare);
        }
    }
    std::vector<FeatureTime> times;
    for (std::size_t i = 0; i < features.size(); ++i)
        times.push_back({features[i], summarise(without), median_interval(std::move(saved[i]))});
    return times;
}

std::int64_t feature_bytes(Feature feature, const FlatScene& scene, const KdTree& tree, const SceneFacts& facts,
                           const TraceConfig& config, bool gl, int width, int height) {
    TraceConfig with = config, without = config;
    with.forced.set(feature, true);
    without.forced.set(feature, false);
    const auto bytes = [&](const SceneNeeds& needs) {
        return gl ? planned_memory(scene, tree, needs, width, height).total() : cpu_table_bytes(tree, needs);
    };
    return bytes(scene_needs(facts, with)) - bytes(stripped(scene_needs(facts, without), info(feature)));
}

}  // namespace kd
