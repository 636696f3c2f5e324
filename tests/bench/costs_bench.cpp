// What counting costs, and what is not asked for: each of the CPU's tracers without counters against itself with them,
// against a twin of its text without the hooks of observers, and one without the step budget as well; and the program's
// tracer against the first of these. Packets have no twins: they have no budget (tile_job.h), and no hooks where they
// do not count. Primary rays by the stack, one thread, in turn.
//
// usage: costs_bench [ROUNDS] [SCENE...]      default 25 rounds of ball:9000, rooms and scatter:10000
//
// Exit code 1 where hooks that nobody listens to or the step budget cost more than is said below, or a hit differs.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/suited_tree.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/bench_rays.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/trace/counters.h"
#include "tests/bench/bench_scene.h"
#include "tests/bench/twin_walks.h"

namespace {

using namespace kd;

/// A tracer's time at most, of that of the twin without it. Hooks that nobody listens to leave no instruction behind;
/// but where one text is compiled twice, its code lies elsewhere in memory, and two compilations of the very same have
/// differed by 3 % here. The budget that ends a single walk is safety that is always there, one subtraction and one
/// branch for each step: 3 % at most where it was measured (docs/performance.md), and as much again for the place of
/// the code.
constexpr double most_for_hooks = 1.05, most_for_budget = 1.06;

struct Way {
    const char* name;
    std::function<void(std::span<Hit>)> trace;
};

/// Places in the list of ways.
enum { plain, counting, same_text, no_hooks, no_budget };

/// Of a scene, and the rays of its picture.
struct Subject {
    FlatScene scene;
    KdTree tree;
    std::vector<Ray> rays;
};

bool at_most(const char* what, const MedianInterval& ratio, double most) {
    std::printf("%s: %s; at most %g is asked\n", what, interval_text(ratio).c_str(), most);
    return ratio.median <= most;
}

bool judge(const std::vector<Way>& ways, const Subject& subject, int rounds) {
    std::vector<std::vector<Hit>> hits(ways.size(), std::vector<Hit>(subject.rays.size()));
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < ways.size(); ++i)
        contestants.push_back({ways[i].name, [&, i] { return TimeSample{wall_ms([&] { ways[i].trace(hits[i]); })}; }});
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = rounds});
    bool same = true;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        std::printf("%-20s %9.2f ms   of the first %s\n", ways[i].name, times[i].total().median_ms,
                    i == plain ? "1" : ratio_text(ratio_interval(times[i].ms(), times[plain].ms())).c_str());
        same = same && std::ranges::equal(hits[i], hits[plain], bit_equal);
    }
    if (!same) std::printf("HITS DIFFER\n");
    if (ways.size() <= same_text) return same;
    const auto over = [&](std::size_t a, std::size_t b) { return ratio_interval(times[a].ms(), times[b].ms()); };
    const bool hooks = at_most("hooks that nobody listens to", over(same_text, no_hooks), most_for_hooks);
    const bool budget = at_most("the step budget", over(no_hooks, no_budget), most_for_budget);
    return same && hooks && budget;
}

bool compare(const std::string& name, const Subject& subject, CpuMode mode, int rounds) {
    const auto& [scene, tree, rays] = subject;
    CpuTracer tracer(scene, tree, mode);
    TraceConfig config;
    config.counters = false;
    SceneView view(scene, tree, mode);
    view.prepare(config);
    std::vector<RayCounters> counters(rays.size());
    const auto twin = [&](Twin which) {
        return [&, which](std::span<Hit> hits) { trace_twin(which, {view, config, rays, false, hits, {}}); };
    };
    std::vector<Way> ways{
        {"without counters", [&](std::span<Hit> hits) { tracer.trace_rays(config, rays, false, hits, {}, 1); }},
        {"counting", [&](std::span<Hit> hits) { tracer.trace_rays(config, rays, false, hits, counters, 1); }},
    };
    if (mode != CpuMode::packet) {
        ways.push_back({"the same text", twin(Twin::whole)});
        ways.push_back({"without hooks", twin(Twin::no_hooks)});
        ways.push_back({"nor step budget", twin(Twin::no_budget)});
    }
    std::printf("%s: %s, %zu triangles, %zu primary rays, stack, 1 thread, %s, %d rounds in turn\n", name.c_str(),
                std::string(tracer_name(mode)).c_str(), scene.triangles.size(), rays.size(), cpu_target_name().c_str(),
                rounds);
    return judge(ways, subject, rounds);
}

bool compare_all(const std::string& name, int rounds) {
    Subject subject{bench_scene(name), {}, {}};
    subject.rays = morton_rays(pinhole(subject.scene.camera, image_size, image_size), image_size, image_size);
    bool kept = true;
    for (const CpuMode mode : {CpuMode::scalar, CpuMode::wide, CpuMode::packet}) {
        subject.tree = build_tree(subject.scene.triangles, suited_tree(mode, {}));
        kept = compare(name, subject, mode, rounds) && kept;
    }
    return kept;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int rounds = argc > 1 ? std::stoi(argv[1]) : 25;
        std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
        if (scenes.empty()) scenes = {"ball:9000", "rooms", "scatter:10000"};
        bool kept = true;
        for (const std::string& scene : scenes) kept = compare_all(scene, rounds) && kept;
        return kept ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "costs_bench: %s\n", error.what());
        return 2;
    }
}
