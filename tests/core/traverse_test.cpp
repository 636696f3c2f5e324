// Every traversal gives the brute-force answer bit for bit, on kind and unkind rays, whatever the tree.

#include <gtest/gtest.h>
#ifdef KD_WITH_RAPIDCHECK
#include <rapidcheck/gtest.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/units.h"
#include "renderer/trace/counters.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

struct Traced {
    std::vector<Hit> hits;
    std::vector<RayCounters> counters;
};

Traced trace(const FlatScene& scene, const KdTree& tree, const TraceConfig& config, const std::vector<Ray>& rays,
             bool any_hit = false) {
    CpuTracer tracer(scene, tree);
    Traced out{std::vector<Hit>(rays.size()), std::vector<RayCounters>(rays.size())};
    tracer.trace_rays(config, rays, any_hit, out.hits, out.counters);
    return out;
}

Traced trace(const FlatScene& scene, const KdTree& tree, Traversal traversal, const std::vector<Ray>& rays,
             LeafLists lists = LeafLists::references, bool any_hit = false) {
    return trace(scene, tree, {.traversal = traversal, .leaf_lists = lists}, rays, any_hit);
}

std::string describe(const Hit& h) {
    char text[96];
    std::snprintf(text, sizeof text, "#%d t=%a", h.triangle, double(h.t));
    return text;
}

/// The paper's ways to store a tree (its section 2.3.1), one changed at a time.
constexpr std::pair<LeafLists, NodeEncoding> storages[] = {{LeafLists::references, NodeEncoding::float4},
                                                           {LeafLists::duplicated, NodeEncoding::float4},
                                                           {LeafLists::references, NodeEncoding::packed}};

/// Empty where every traversal agrees with the naive loop on every ray, else the first failure.
std::string first_mismatch(const FlatScene& scene, const KdTree& tree, const std::vector<Ray>& rays) {
    const Traced expected = trace(scene, tree, Traversal::naive, rays);
    for (const TraversalInfo& t : traversals())
        for (const auto& [lists, nodes] : storages) {
            if (t.id == Traversal::naive) continue;
            const Traced found = trace(scene, tree, {.traversal = t.id, .leaf_lists = lists, .nodes = nodes}, rays);
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (!bit_equal(found.hits[i], expected.hits[i]))
                    return std::string(t.name) + ": " + test::hex(rays[i]) + " expected " + describe(expected.hits[i]) +
                           " found " + describe(found.hits[i]);
        }
    return {};
}

FlatScene with_tree(std::vector<Triangle> triangles, KdTree& tree, const BuildConfig& config = {}) {
    FlatScene scene = test::scene_of(std::move(triangles));
    tree = build_tree(scene.triangles, config);
    return scene;
}

TEST(Traverse, AgreesWithBruteForceOnASoup) {
    KdTree tree;
    const FlatScene scene = with_tree(test::random_soup(400, 0.1f, 7), tree);
    EXPECT_EQ(first_mismatch(scene, tree, test::unkind_rays(scene.triangles, 20000, 1)), "");
}

TEST(Traverse, AgreesWithBruteForceOnLatticeRays) {
    // Case T09 to T12 of the stress list: cubes on integer planes, rays inside those planes and through corners.
    KdTree tree;
    const FlatScene scene = with_tree(test::voxel_city(4), tree);
    test::Random random(3);
    std::vector<Ray> rays = test::unkind_rays(scene.triangles, 10000, 2);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 o(float(random.below(7) - 1), float(random.below(7) - 1), float(random.below(7) - 1));
        const Vec3 d(float(random.below(3) - 1), float(random.below(3) - 1), float(random.below(3) - 1));
        rays.push_back({o, d, 0.0f, KD_T_LIMIT, -1});
    }
    EXPECT_EQ(first_mismatch(scene, tree, rays), "");
}

TEST(Traverse, NodesOfEightBytesAreWalkedInTheSameSteps) {
    KdTree tree;
    const FlatScene scene = with_tree(test::random_soup(400, 0.1f, 11), tree);
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 5000, 4);
    for (const RulesInfo& rules : all_rules())
        for (const TraversalInfo& t : traversals()) {
            TraceConfig config{.traversal = t.id, .rules = rules.id};
            const Traced wide = trace(scene, tree, config, rays);
            config.nodes = NodeEncoding::packed;
            const Traced packed = trace(scene, tree, config, rays);
            EXPECT_EQ(wide.counters, packed.counters) << t.name << ", " << rules.name;
            for (std::size_t i = 0; i < rays.size(); ++i)
                ASSERT_TRUE(bit_equal(wide.hits[i], packed.hits[i])) << t.name << ", " << rules.name;
        }
}

TEST(Traverse, NeverMissesAClosedSphereAtVerticesAndEdges) {
    KdTree tree;
    const FlatScene scene = with_tree(test::stress_sphere(80, 40), tree);
    test::Random random(5);
    std::vector<Ray> rays;
    for (int i = 0; i < 40000; ++i) {
        const Triangle& t = scene.triangles[std::size_t(random.below(int(scene.triangles.size())))];
        const Vec3 o = random.point(-0.3f, 0.3f);
        const Vec3 at = i % 2 ? t.corner[0] : glm::mix(t.corner[0], t.corner[1], random.uniform(0, 1));
        rays.push_back({o, at - o, 0.0f, KD_T_LIMIT, -1});
    }
    for (const TraversalInfo& t : traversals()) {
        const Traced found = trace(scene, tree, t.id, rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_GE(found.hits[i].triangle, 0) << t.name << " " << test::hex(rays[i]);
    }
}

TEST(Traverse, NeverMissesAClosedSphereFarFromTheOrigin) {
    // Case T18: coordinates are so coarse here (1/64) that many origins lie exactly on split planes.
    const Vec3 centre(148376.0f, 1234.0f, -223423.0f);
    KdTree tree;
    const FlatScene scene = with_tree(test::stress_sphere(100, 50, 2.0f, centre), tree);
    test::Random random(17);
    std::vector<Ray> rays;
    for (int i = 0; i < 20000; ++i)
        rays.push_back(
            to_internal(scene, Ray{centre + random.point(-1, 1), random.point(-1, 1), 0.0f, KD_T_LIMIT, -1}));
    EXPECT_EQ(first_mismatch(scene, tree, rays), "");
    const Traced found = trace(scene, tree, Traversal::stack, rays);
    EXPECT_EQ(std::ranges::count(found.hits, -1, &Hit::triangle), 0);
}

TEST(Traverse, RaysFromFarAwayCostNoMoreThanOthers) {
    KdTree tree;
    const FlatScene scene = with_tree(test::stress_sphere(80, 40), tree);
    test::Random random(23);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 at = random.point(-0.7f, 0.7f);
        const Vec3 from = random.point(-1, 1) * std::pow(10.0f, random.uniform(1.0f, 7.0f));
        rays.push_back({from, at - from, 0.0f, KD_T_LIMIT, -1});
    }
    EXPECT_EQ(first_mismatch(scene, tree, rays), "");
    CounterTotals totals;
    for (const RayCounters& c : trace(scene, tree, Traversal::stack, rays).counters) totals.add(c);
    EXPECT_LT(totals.interior_first, 60 * totals.rays);
}

TEST(Traverse, FromOnASplitPlaneSeesBothSides) {
    // Two walls either side of x = 0.5, where the tree is made to split; rays start on the plane (case T32).
    std::vector<Triangle> walls;
    for (float x : {0.0f, 1.0f}) walls.push_back({{Vec3(x, -9, -9), Vec3(x, 9, -9), Vec3(x, 0, 9)}});
    const FlatScene scene = test::scene_of(walls);
    KdTree tree;
    tree.bounds = scene.bounds;
    tree.nodes.assign(3, TreeNode{});
    tree.nodes[0].flag = 0;
    tree.nodes[0].split = 0.5f;
    tree.nodes[0].link = 2;
    for (std::int32_t leaf : {1, 2}) {
        tree.nodes[std::size_t(leaf)].count = 1;
        tree.nodes[std::size_t(leaf)].link = leaf - 1;
        tree.nodes[std::size_t(leaf)].parent = 0;
    }
    tree.references = {0, 1};
    std::vector<Ray> rays;
    for (float dx : {1.0f, -1.0f, 1e-6f, -1e-6f, 0.0f, -0.0f})
        for (float dy : {0.0f, -0.0f, 0.25f}) rays.push_back({Vec3(0.5f, 0, 0), Vec3(dx, dy, 0), 0.0f, KD_T_LIMIT, -1});
    EXPECT_EQ(first_mismatch(scene, tree, rays), "");
    const Traced straight = trace(scene, tree, Traversal::stack, {rays[0], rays[3]});
    EXPECT_EQ(straight.hits[0].triangle, 1);
    EXPECT_EQ(straight.hits[1].triangle, 0);
    EXPECT_EQ(straight.hits[0].t, 0.5f);
}

TEST(Traverse, TiesGoToTheLowestTriangleNumber) {
    const Triangle t{{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}};
    std::vector<Triangle> same(40, t);
    for (const Triangle& extra : test::random_soup(60, 0.05f, 3)) same.push_back(extra);
    std::ranges::rotate(same, same.begin() + 60);
    KdTree tree;
    const FlatScene scene = with_tree(same, tree);
    const std::vector<Ray> rays{{Vec3(0.3f, 0.3f, 3), Vec3(0, 0, -1), 0.0f, KD_T_LIMIT, -1}};
    for (const TraversalInfo& info : traversals())
        EXPECT_EQ(trace(scene, tree, info.id, rays).hits[0].triangle,
                  trace(scene, tree, Traversal::naive, rays).hits[0].triangle)
            << info.name;
}

TEST(Traverse, InvalidRaysHitNothingAndSaySo) {
    KdTree tree;
    const FlatScene scene = with_tree(test::stress_sphere(8, 6), tree);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<Ray> rays{{Vec3(nan, 0, 0), Vec3(1, 0, 0), 0, 1e30f, -1},
                                {Vec3(0), Vec3(nan, 1, 0), 0, 1e30f, -1},
                                {Vec3(inf, 0, 0), Vec3(1, 0, 0), 0, 1e30f, -1},
                                {Vec3(0), Vec3(0, -inf, 0), 0, 1e30f, -1},
                                {Vec3(0), Vec3(0), 0, 1e30f, -1},
                                {Vec3(0), Vec3(1, 0, 0), 2, 1, -1},
                                {Vec3(0), Vec3(1, 0, 0), nan, 1e30f, -1},
                                {Vec3(0), Vec3(1, 0, 0), 0, nan, -1}};
    for (const TraversalInfo& info : traversals()) {
        const Traced found = trace(scene, tree, info.id, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_EQ(found.hits[i].triangle, -1) << info.name << " ray " << i;
            EXPECT_EQ(found.counters[i].exit_reason, uint(KD_EXIT_INVALID_RAY)) << info.name << " ray " << i;
        }
    }
}

TEST(Traverse, KeepsToTheOpenInterval) {
    KdTree tree;
    const FlatScene scene = with_tree({{{Vec3(-1, -1, 2), Vec3(1, -1, 2), Vec3(0, 1, 2)}}}, tree);
    const auto hits = [&](float t_min, float t_max) {
        return trace(scene, tree, Traversal::stack, {{Vec3(0), Vec3(0, 0, 1), t_min, t_max, -1}}).hits[0].triangle == 0;
    };
    EXPECT_TRUE(hits(0.0f, 2.5f));
    EXPECT_FALSE(hits(0.0f, 2.0f)) << "a light exactly at the blocker is not shadowed by it";
    EXPECT_FALSE(hits(2.0f, 3.0f));
    EXPECT_TRUE(hits(1.99f, 2.01f));
}

TEST(Traverse, SourceTriangleIsNotHitAgain) {
    KdTree tree;
    const FlatScene scene = with_tree({{{Vec3(-1, -1, 2), Vec3(1, -1, 2), Vec3(0, 1, 2)}}}, tree);
    const Ray ray{Vec3(0), Vec3(0, 0, 1), 0.0f, KD_T_LIMIT, 0};
    for (const TraversalInfo& info : traversals())
        EXPECT_EQ(trace(scene, tree, info.id, {ray}).hits[0].triangle, -1) << info.name;
}

TEST(Traverse, RestartVisitsTheSameNodesAsStackAndPaysInRevisits) {
    KdTree tree;
    const FlatScene scene = with_tree(test::random_soup(500, 0.05f, 11), tree);
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 5000, 4);
    const Traced stack = trace(scene, tree, Traversal::stack, rays);
    const Traced restart = trace(scene, tree, Traversal::restart, rays);
    CounterTotals again;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(stack.counters[i].interior_first, restart.counters[i].interior_first) << test::hex(rays[i]);
        ASSERT_EQ(stack.counters[i].leaves, restart.counters[i].leaves) << test::hex(rays[i]);
        ASSERT_EQ(stack.counters[i].triangle_tests, restart.counters[i].triangle_tests);
        ASSERT_EQ(stack.counters[i].interior_again, 0u);
        ASSERT_EQ(stack.counters[i].restarts, 0u);
        again.add(restart.counters[i]);
    }
    EXPECT_GT(again.interior_again, again.interior_first) << "restart re-visits more than it visits on a soup";
    EXPECT_GT(again.restarts, 0u);
}

TEST(Traverse, AViewInASymmetryPlaneIsNotPunished) {
    // The camera lies exactly on the first split planes of a centred scene; a rule that visits both sides in full there
    // costs several times the steps of a camera moved aside by a hair.
    KdTree tree;
    const FlatScene scene = with_tree(test::stress_sphere(40, 20), tree);
    const auto visits = [&](Vec3 eye) {
        std::vector<Ray> rays;
        for (int i = 0; i < 64 * 64; ++i)
            rays.push_back({eye, Vec3(float(i % 64) - 31.7f, float(i / 64) - 31.3f, -100.0f), 0.0f, KD_T_LIMIT, -1});
        CounterTotals totals;
        for (const RayCounters& c : trace(scene, tree, Traversal::stack, rays).counters) totals.add(c);
        return double(totals.interior_first);
    };
    EXPECT_LT(visits(Vec3(0, 0, 4)), 1.1 * visits(Vec3(1e-3f, 1e-3f, 4)));
}

TEST(Traverse, AnyHitFindsSomethingExactlyWhereThereIsSomething) {
    KdTree tree;
    const FlatScene scene = with_tree(test::random_soup(300, 0.1f, 9), tree);
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 5000, 8);
    const Traced expected = trace(scene, tree, Traversal::naive, rays);
    for (const TraversalInfo& info : traversals()) {
        const Traced found = trace(scene, tree, info.id, rays, LeafLists::references, true);
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_EQ(found.hits[i].triangle >= 0, expected.hits[i].triangle >= 0)
                << info.name << " " << test::hex(rays[i]);
    }
}

#ifdef KD_WITH_RAPIDCHECK
RC_GTEST_PROP(TraverseProperty, AgreesWithBruteForce, ()) {
    const auto seed = unsigned(*rc::gen::inRange(0, 1 << 30));
    const int n = *rc::gen::inRange(0, 300);
    const float size = *rc::gen::element(0.001f, 0.05f, 0.5f);
    BuildConfig config;
    config.builder = builders()[*rc::gen::inRange<std::size_t>(0, builders().size())].name;
    config.trim_leaves = *rc::gen::arbitrary<bool>();
    config.leaf_size = *rc::gen::inRange(1, 5);
    config.empty_bonus = *rc::gen::element(0.0f, 0.2f, 0.9f);
    config.max_depth = *rc::gen::element(0, 1, 3, 40, 64);
    std::vector<Triangle> triangles = test::random_soup(n, size, seed);
    // Snapping to a coarse grid makes shared planes, edges and exact ties common.
    if (*rc::gen::arbitrary<bool>())
        for (Triangle& t : triangles)
            for (Vec3& p : t.corner) p = glm::floor(p * 8.0f) / 8.0f;
    std::vector<Triangle> aims = triangles;
    if (aims.empty()) aims.push_back({{Vec3(0), Vec3(1), Vec3(0, 1, 0)}});
    KdTree tree;
    const FlatScene scene = with_tree(triangles, tree, config);
    RC_LOG() << "seed " << seed;
    RC_ASSERT(first_mismatch(scene, tree, test::unkind_rays(aims, 300, seed)) == "");
}
#endif

}  // namespace
}  // namespace kd
