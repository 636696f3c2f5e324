// What counting costs, and that what is not asked for costs nothing: the stack traversal without counters against
// itself with them, against a twin of its text without the hooks of observers, and one without the step budget as well;
// and the program's tracer against the first of these. Primary rays, one thread, in turn.
//
// usage: costs_bench [ROUNDS] [SCENE...]      default 25 rounds of ball:9000, rooms and scatter:10000
//
// Exit code 1 where hooks that nobody listens to cost more than is said below, or a hit differs.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/bench_rays.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/trace/counters.h"
#include "tests/bench/bench_scene.h"
#include "tests/bench/twin_walks.h"

namespace {

using namespace kd;

/// Of the time of the twin without hooks: where one text is compiled twice, its code lies elsewhere in memory, and two
/// compilations of the very same have differed by 3 % here.
constexpr double most_for_hooks = 1.05;

struct Way {
    const char* name;
    std::function<void(std::span<Hit>)> trace;
};

bool compare(const std::string& name, int rounds) {
    const FlatScene scene = bench_scene(name);
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = morton_rays(pinhole(scene.camera, image_size, image_size), image_size, image_size);
    CpuTracer tracer(scene, tree);
    TraceConfig config;
    config.counters = false;
    SceneView view(scene, tree);
    view.prepare(config);
    std::vector<RayCounters> counters(rays.size());
    const auto twin = [&](Twin which) {
        return [&, which](std::span<Hit> hits) { trace_twin(which, view, config, rays, hits); };
    };
    const std::vector<Way> ways{
        {"kdscope", [&](std::span<Hit> hits) { tracer.trace_rays(config, rays, false, hits, {}, 1); }},
        {"kdscope, counting", [&](std::span<Hit> hits) { tracer.trace_rays(config, rays, false, hits, counters, 1); }},
        {"the same text", twin(Twin::whole)},
        {"without hooks", twin(Twin::no_hooks)},
        {"nor step budget", twin(Twin::no_budget)},
    };
    std::vector<std::vector<Hit>> hits(ways.size(), std::vector<Hit>(rays.size()));
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < ways.size(); ++i)
        contestants.push_back({ways[i].name, [&, i] { return TimeSample{wall_ms([&] { ways[i].trace(hits[i]); })}; }});
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = rounds});

    std::printf("%s, %zu triangles, %zu primary rays, stack, 1 thread, %s, %d rounds in turn\n", name.c_str(),
                scene.triangles.size(), rays.size(), cpu_target_name().c_str(), rounds);
    bool same = true;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        std::printf("%-20s %9.2f ms   of kdscope %s\n", ways[i].name, times[i].total().median_ms,
                    i == 0 ? "1" : ratio_text(ratio_interval(times[i].ms(), times[0].ms())).c_str());
        same = same && std::ranges::equal(hits[i], hits[0], bit_equal);
    }
    const MedianInterval hooks = ratio_interval(times[2].ms(), times[3].ms());
    std::printf("hooks that nobody listens to: %s; at most %g is asked\n", ratio_text(hooks).c_str(), most_for_hooks);
    if (!same) std::printf("HITS DIFFER\n");
    return same && hooks.median <= most_for_hooks;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int rounds = argc > 1 ? std::stoi(argv[1]) : 25;
        std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
        if (scenes.empty()) scenes = {"ball:9000", "rooms", "scatter:10000"};
        bool kept = true;
        for (const std::string& scene : scenes) kept = compare(scene, rounds) && kept;
        return kept ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "costs_bench: %s\n", error.what());
        return 2;
    }
}
