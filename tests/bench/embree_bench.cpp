// kdscope's traversals against Embree's rtcIntersect1 on the same primary rays, one thread, in turn, in one run.
//
// usage: embree_bench [SCENE] [ROUNDS]      default ball:9000, 15 rounds

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/timing.h"
#include "tests/bench/bench_scene.h"
#include "tests/bench/embree_tracer.h"

namespace {

using namespace kd;

std::size_t count_hits(const std::vector<Hit>& hits) {
    return std::size_t(std::ranges::count_if(hits, [](const Hit& h) { return h.triangle >= 0; }));
}

constexpr float different_t = 1e-4f;

/// Rays that hit in one list and miss in the other, or whose t differ by more than 1e-4 of it: a thousand times the
/// rounding of either, and less than what parts two surfaces of these scenes. What the rest differ by most is printed.
std::size_t count_different(const std::vector<Hit>& found, const std::vector<Hit>& other) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool hits = found[i].triangle >= 0, others = other[i].triangle >= 0;
        different += hits != others || (hits && std::abs(found[i].t - other[i].t) > different_t * other[i].t);
    }
    return different;
}

/// The largest difference of t of rays that hit in both lists and do not count as different, as a share of t.
float largest_difference(const std::vector<Hit>& found, const std::vector<Hit>& other) {
    float largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].triangle >= 0 && other[i].triangle >= 0) {
            const float difference = std::abs(found[i].t - other[i].t) / other[i].t;
            if (difference <= different_t) largest = std::max(largest, difference);
        }
    return largest;
}

/// Of Embree's speed in robust mode, by the stack traversal.
constexpr double least_share = 0.75;

int run(const std::string& name, int rounds) {
    const FlatScene scene = bench_scene(name);
    const BuildConfig build;
    const KdTree tree = build_tree(scene.triangles, build);
    const std::vector<Ray> rays = primary_rays(scene);
    CpuTracer tracer(scene, tree);
    const EmbreeTracer robust(scene, RTC_SCENE_FLAG_ROBUST), standard(scene, RTC_SCENE_FLAG_NONE);

    std::vector<std::vector<Hit>> hits;
    std::vector<Contestant> contestants;
    const auto compete = [&](std::string label, auto trace) {
        const std::size_t slot = hits.size();
        hits.emplace_back(rays.size());
        contestants.push_back(
            {std::move(label), [&hits, slot, trace] { return TimeSample{wall_ms([&] { trace(hits[slot]); })}; }});
    };
    compete("embree robust", [&](std::vector<Hit>& out) { robust.trace(rays, out); });
    compete("embree default", [&](std::vector<Hit>& out) { standard.trace(rays, out); });
    for (const TraversalInfo& t : traversals()) {
        if (t.id == Traversal::naive) continue;
        for (const LeafLists lists : {LeafLists::references, LeafLists::duplicated})
            compete("kdscope " + std::string(t.name) + (lists == LeafLists::duplicated ? ", copies" : ""),
                    [&, id = t.id, lists](std::vector<Hit>& out) {
                        TraceConfig config;
                        config.traversal = id;
                        config.leaf_lists = lists;
                        tracer.trace_rays(config, rays, false, out, {}, 1);
                    });
    }
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = rounds});

    std::printf("%s, %zu triangles, %dx%d primary rays in Morton order, 1 thread, %s, %d rounds in turn\n",
                name.c_str(), scene.triangles.size(), image_size, image_size, cpu_target_name().c_str(), rounds);
    std::printf("builder %s: t_t %g, t_i %g, empty bonus %g (gate %g), leaf size %d, depth %d, bad refines %d, leaves "
                "trimmed to %s\n",
                build.builder.c_str(), double(build.traversal_cost), double(build.intersection_cost),
                double(build.empty_bonus), double(build.empty_bonus_gate), build.leaf_size,
                depth_limit(build, scene.triangles.size()), build.bad_refines,
                build.trim_leaves ? "surfaces" : "boxes");
    std::printf("%-24s %9s %19s %9s %12s %12s %9s %9s\n", "tracer", "ms", "[p25 - p75]", "Mrays/s", "x robust",
                "x default", "hits", "differ");
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        const TimeSummary t = times[i].total();
        std::printf("%-24s %9.2f [%7.2f - %7.2f] %9.2f %12.3f %12.3f %9zu %9zu\n", contestants[i].name.c_str(),
                    t.median_ms, t.p25_ms, t.p75_ms, double(rays.size()) / t.median_ms / 1e3,
                    times[0].total().median_ms / t.median_ms, times[1].total().median_ms / t.median_ms,
                    count_hits(hits[i]), count_different(hits[i], hits[0]));
    }
    const auto stack = std::ranges::find(contestants, "kdscope stack", &Contestant::name) - contestants.begin();
    const double share = times[0].total().median_ms / times[std::size_t(stack)].total().median_ms;
    std::printf("differ: rays that hit where embree robust misses, or miss where it hits, or whose t is %g of it off;\n"
                "the stack's other t are off by %.1e at most\n"
                "kdscope stack makes %.3f of embree robust's speed; %s\n",
                double(different_t), double(largest_difference(hits[std::size_t(stack)], hits[0])), share,
                share >= least_share ? "at least 0.75 is asked" : "BELOW the 0.75 that is asked");
    const std::size_t different = count_different(hits[std::size_t(stack)], hits[0]);
    if (different > 0) std::printf("%zu HITS of kdscope stack DIFFER\n", different);
    return share >= least_share && different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? argv[1] : "ball:9000", argc > 2 ? std::stoi(argv[2]) : 15);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embree_bench: %s\n", error.what());
        return 2;
    }
}
