// What robustness costs: the stack traversal under the robust rules against the published ones, same triangle test,
// same primary rays, one thread, in turn.
//
// usage: robustness_bench [ROUNDS] [SCENE...]      default 25 rounds of ball:9000 and scatter:10000
//
// Exit code 1 where it costs more than is said below.

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/bench_rays.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "tests/bench/bench_scene.h"
#include "tests/bench/rule_steps.h"

namespace {

using namespace kd;

/// Of the time of the rules as published, on the scenes whose numbers are published.
double most_time(const std::string& scene) {
    if (scene == "ball:9000") return 1.15;
    if (scene == "scatter:10000") return 1.25;
    return std::numeric_limits<double>::infinity();
}

/// False, and told, where a bound is broken.
bool within(const char* what, double share, double most) {
    const bool kept = share <= most;
    if (std::isfinite(most))
        std::printf("%s: %.3f of those as published; %s the %.2f that is allowed\n", what, share,
                    kept ? "within" : "BEYOND", most);
    return kept;
}

/// Whether the bounds are kept.
bool compare(const std::string& name, int rounds) {
    const FlatScene scene = bench_scene(name);
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = morton_rays(pinhole(scene.camera, image_size, image_size), image_size, image_size);
    CpuTracer tracer(scene, tree);
    std::vector<Hit> hits(rays.size());
    std::printf("%s, %zu triangles, %zu primary rays, stack, 1 thread, %s, %d rounds in turn\n", name.c_str(),
                scene.triangles.size(), rays.size(), cpu_target_name().c_str(), rounds);

    std::vector<TraceConfig> configs;
    for (const RulesInfo& rules : all_rules()) {
        configs.emplace_back();
        configs.back().rules = rules.id;
    }
    std::vector<Contestant> contestants;
    for (const TraceConfig& config : configs)
        contestants.push_back(
            {"", [&] { return TimeSample{wall_ms([&] { tracer.trace_rays(config, rays, false, hits, {}, 1); })}; }});
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = rounds});
    const auto robust = double(stack_steps(tracer, Rules::robust, rays));
    bool kept = true;
    std::printf("%-16s %9s %12s %12s   %s\n", "rules", "ms", "steps/ray", "robust costs",
                "robust / these, per round [95 %]");
    for (std::size_t i = 0; i < configs.size(); ++i) {
        const auto steps = double(stack_steps(tracer, configs[i].rules, rays));
        const MedianInterval ratio = ratio_interval(times[0].ms(), times[i].ms());
        std::printf("%-16s %9.2f %12.2f %+10.1f %%   time x %.3f [%.3f - %.3f]\n",
                    std::string(info(configs[i].rules).name).c_str(), times[i].total().median_ms,
                    steps / double(rays.size()), 100 * (robust / steps - 1), ratio.median, ratio.low, ratio.high);
        if (configs[i].rules != Rules::as_published) continue;
        kept = within("steps", robust / steps, most_robust_steps) && kept;
        kept = within("time", ratio.median, most_time(name)) && kept;
    }
    return kept;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int rounds = argc > 1 ? std::stoi(argv[1]) : 25;
        std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
        if (names.empty()) names = {"ball:9000", "scatter:10000"};
        bool kept = true;
        for (const std::string& name : names) kept = compare(name, rounds) && kept;
        return kept ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "robustness_bench: %s\n", error.what());
        return 2;
    }
}
