// Limits of stacks, trails and loops: what lies at them works, what lies beyond is refused or flagged.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/geometry/refusal.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/kdtree/validate.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/measure/stability/grouped_text.h"
#include "renderer/measure/timing.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::size_t full = 1'000'000;

/// `depth` triangles at x = 1, 1/2, 1/4, ... and one more at x = 0, each in a leaf of its own at a level of its own.
/// The nodes lie on one path: the child below each split holds all the rest.
Subject chain(CaseRun& run, int depth) {
    std::vector<Triangle> walls;
    for (int i = 0; i <= depth; ++i) {
        const float x = i == depth ? 0.0f : std::ldexp(1.0f, -i);
        walls.push_back({{Vec3(x, -1, -1), Vec3(x, 1, -1), Vec3(x, 0, 1)}});
    }
    Subject made;
    made.scene = bare_scene(walls);
    made.tree.bounds = made.scene.bounds;
    made.tree.nodes.clear();
    for (int i = 0; i < depth; ++i) {
        TreeNode node;
        node.flag = 0;
        node.split = 0.75f * std::ldexp(1.0f, -i);
        node.link = 2 * depth - i;  // leaves above come after all interior nodes and the last leaf, deepest first
        node.parent = i - 1;
        made.tree.nodes.push_back(node);
    }
    const auto add_leaf = [&](int triangle, int parent) {
        TreeNode leaf;
        leaf.count = 1;
        leaf.link = int(made.tree.references.size());
        leaf.parent = parent;
        made.tree.references.push_back(triangle);
        made.tree.nodes.push_back(leaf);
    };
    add_leaf(depth, depth - 1);
    for (int i = depth - 1; i >= 0; --i) add_leaf(i, i);
    for (const Violation& v : validate(made.tree, made.scene.triangles, 1))
        run.record("tree", 1, 1, fmt::format("chain of depth {}: node {}: {}", depth, v.node, v.message));
    return made;
}

void run_chain(CaseRun& run, int depth, std::size_t count) {
    const Subject subject = chain(run, depth);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        // Both ways along the chain, past all walls, and from between them.
        const float turn = i % 2 == 0 ? 1.0f : -1.0f;
        Vec3 from = random_point(run.random(), -0.9f, 0.9f), to = random_point(run.random(), -1.6f, 1.6f);
        from.x = i % 3 == 0 ? std::ldexp(1.0f, -random_below(run.random(), depth + 1)) * 1.2f : -1.5f * turn;
        to.x = 2 * turn;
        if (i % 4 == 0) from = Vec3(-2 * turn, 3, 0), to = Vec3(2 * turn, 0.999f, -0.999f);
        rays.push_back(ray_to(from, to));
    }
    Expectation e;
    e.what = fmt::format("depth {}: ", depth);
    run.check(subject, rays, e);
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        std::vector<Hit> hits(rays.size());
        std::vector<RayCounters> counters(rays.size());
        (void)machine.trace(trace, rays, false, hits, counters, run.stop());
        run.check_stop();
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (counters[i].exit_reason > uint(KD_EXIT_HIT) || counters[i].stack_depth > uint(max_tree_depth))
                CaseRun::fail(row, fmt::format("{}{}: ray {}", e.what, exit_reason_name(counters[i].exit_reason),
                                               exact_text(rays[i])));
    });
}

constexpr int naive_counts[] = {gl_step_budget, gl_step_budget + 1, 65'534, 65'536, 100'000};

/// The naive traversal of `count` triangles on each machine: as on the CPU, or refused with a reason.
void run_naive(CaseRun& run, int count) {
    Random& random = run.random();
    const Subject soup = run.subject(random_soup(count, 0.02f, random), BuildConfig{.leaf_size = 64, .max_depth = 8});
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < run.rays(10'000, std::size(naive_counts)); ++i)
        rays.push_back(ray_to(random_point(random, -1, 2), random_point(random, 0, 1)));
    const std::vector<Hit> expected = run.loop_hits(soup.scene, rays);
    run.each(soup, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow&) {
        TraceConfig naive;
        naive.traversal = Traversal::naive;
        if (trace.traversal != Traversal::stack || !machine.has_walk(naive)) return;
        StabilityRow& row = run.row(machine.tracer(), machine.context(), info(Traversal::naive).name);
        std::vector<Hit> hits(rays.size());
        std::string refused;
        row.seconds += 1e-3 * wall_ms([&] {
                           refused = refusal([&] { (void)machine.trace(naive, rays, false, hits, {}, run.stop()); });
                       });
        run.check_stop();
        row.n += std::int64_t(rays.size());
        if (refused.empty()) CaseRun::tell_error_of_t(soup.scene, rays, hits, row);
        const bool fits = machine.on_cpu() || count <= gl_step_budget;
        if (fits != refused.empty())
            CaseRun::fail(row, fmt::format("{} triangles: {}", count, fits ? refused : "not refused"));
        for (std::size_t i = 0; i < rays.size() && refused.empty(); ++i)
            if (!bit_equal(hits[i], expected[i]))
                CaseRun::fail(row, fmt::format("{} triangles: ray {}: expected {}, found {}", count,
                                               exact_text(rays[i]), exact_text(expected[i]), exact_text(hits[i])));
    });
}

/// Along diagonals, each through a corner of the city's lattice.
std::vector<Ray> rays_through_corners(Random& random, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 corner;
        for (int axis = 0; axis < 3; ++axis) corner[axis] = float(random_below(random, 11));
        const Vec3 d(random_sign(random), random_sign(random), random_sign(random));
        rays.push_back(ray_along(corner - 20.0f * d, d));
    }
    return rays;
}

/// On the CPU, with no more than the usual budget.
std::vector<Hit> whole_walks(const CaseRun& run, const Subject& subject, const std::vector<Ray>& rays) {
    std::vector<Hit> hits(rays.size());
    CpuTracer tracer(subject.scene, subject.tree);
    (void)tracer.trace_rays({.rules = run.rules()}, rays, false, hits, {}, run.threads(), run.stop());
    run.check_stop();
    return hits;
}

/// What is flagged is not what the machine under test would answer with a larger budget, but what the CPU does.
void run_stuck(CaseRun& run) {
    const Subject city = run.subject(voxel_city(10));
    const std::vector<Ray> rays = rays_through_corners(run.random(), run.rays(full));
    const std::vector<Hit> expected = run.loop_hits(city.scene, rays), whole = whole_walks(run, city, rays);
    std::int64_t fewest = std::int64_t(rays.size());
    run.each(city, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        TraceConfig guarded = trace;
        guarded.step_budget = 64;
        std::vector<Hit> hits(rays.size());
        std::vector<RayCounters> counters(rays.size());
        (void)machine.trace(guarded, rays, false, hits, counters, run.stop());
        run.check_stop();
        const auto is_flagged = [](const RayCounters& c) { return c.exit_reason == uint(KD_EXIT_STEP_CAP); };
        const std::int64_t flagged = std::ranges::count_if(counters, is_flagged);
        fewest = std::min(fewest, flagged);
        row.n += std::int64_t(rays.size());
        CaseRun::tell_error_of_t(city.scene, rays, hits, row);
        row.reason = fmt::format("{} of {} flagged and traced again on the CPU", flagged, rays.size());
        if (flagged == 0) CaseRun::fail(row, "no ray was flagged");
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool again = is_flagged(counters[i]);
            const Hit& found = again ? whole[i] : hits[i];
            if (!bit_equal(found, expected[i]))
                CaseRun::fail(row, fmt::format("{}: ray {}: expected {}, found {}",
                                               again ? "wrong when traced again" : "silently wrong",
                                               exact_text(rays[i]), exact_text(expected[i]), exact_text(found)));
        }
    });
    run.record("flagged", std::int64_t(rays.size()), fewest > 0 ? 0 : 1, fmt::format("at least {} flagged", fewest));
}

}  // namespace

StabilityCase case_T48() {
    return {
        "T48",
        "Depth of the stack",
        "Chains of walls at x = 1, 1/2, 1/4, ..., trees of depth 1 to 64 with one leaf at each level; rays both ways",
        "brute force",
        "0 mismatches, no stack overflow, no step cap",
        [](CaseRun& run) {
            for (int depth = 1; depth <= max_tree_depth; ++depth) run_chain(run, depth, run.rays(full, max_tree_depth));
        }};
}

StabilityCase case_T49() {
    return {"T49",
            "Bits of the restart trail",
            "The chains of T48 of depth 31, 32, 33, 63 and 64",
            "brute force",
            "0 mismatches, no step cap",
            [](CaseRun& run) {
                for (const int depth : {31, 32, 33, 63, 64}) run_chain(run, depth, run.rays(full, 5));
            }};
}

StabilityCase case_T50() {
    static const std::string construction =
        fmt::format("Every triangle tested, no tree: {}, {}, 65,534, 65,536 and 100,000 triangles",
                    grouped_text(gl_step_budget), grouped_text(gl_step_budget + 1));
    static const std::string acceptance =
        fmt::format("the same hits, or refused with the numbers above {} on OpenGL", grouped_text(gl_step_budget));
    return {"T50", "Loop budget", construction, "brute force on the CPU", acceptance, [](CaseRun& run) {
                for (const int count : naive_counts) run_naive(run, count);
                const std::string refused = refusal([] {
                    TraceConfig naive;
                    naive.traversal = Traversal::naive;
                    check_config({.triangles = 1'000'000}, naive, {134'217'728, 16384});
                });
                run.record("1e6 triangles", 1, refused.empty() ? 1 : 0, refused);
            }};
}

StabilityCase case_T51() {
    return {
        "T51",
        "Rays that are stopped",
        "Diagonal rays through corners of a voxel city with a budget of 64 steps; those flagged are traced again by "
        "the case itself, on the CPU with the whole budget (frames leave such rays as they are, flagged)",
        "brute force",
        "some are flagged, as many are told; none is silently wrong, and with those traced again all are right",
        run_stuck};
}

}  // namespace kd
