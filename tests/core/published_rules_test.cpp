// Walks as published: right on kind rays, wrong where the literature and our measurements say, never endless unseen.

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/trace/counters.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

struct Count {
    int wrong = 0, capped = 0;
};

/// Rays that the walk answers otherwise than the loop over all triangles, and rays that it gave up.
Count count_wrong(const FlatScene& scene, const KdTree& tree, Traversal traversal, Rules rules,
                  const std::vector<Ray>& rays) {
    CpuTracer tracer(scene, tree);
    std::vector<Hit> expected(rays.size()), found(rays.size());
    std::vector<RayCounters> counters(rays.size());
    TraceConfig config;
    config.traversal = Traversal::naive;
    tracer.trace_rays(config, rays, false, expected, {});
    config.traversal = traversal;
    config.rules = rules;
    tracer.trace_rays(config, rays, false, found, counters);
    Count count;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        count.wrong += !bit_equal(expected[i], found[i]);
        count.capped += counters[i].exit_reason == KD_EXIT_STEP_CAP;
    }
    return count;
}

std::vector<Traversal> published_walks() {
    std::vector<Traversal> walks;
    for (const TraversalInfo& t : traversals())
        if (t.has_published_form()) walks.push_back(t.id);
    return walks;
}

std::vector<Ray> kind_rays(int count) {
    test::Random random(31);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) rays.push_back({random.point(-1, 2), random.point(-1, 1), 0.0f, KD_T_LIMIT, -1});
    return rays;
}

/// Axis-parallel rays between the planes of the lattice, zeros of both signs.
std::vector<Ray> rays_along_axes(int count, float zero) {
    test::Random random(4);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        Vec3 d(zero);
        d[i % 3] = i % 2 ? 1.0f : -1.0f;
        Vec3 o = random.point(0.1f, 3.9f);
        o[i % 3] = i % 2 ? -1.0f : 5.0f;
        rays.push_back({o, d, 0.0f, KD_T_LIMIT, -1});
    }
    return rays;
}

/// As above with integer origins: inside the planes of the lattice.
std::vector<Ray> lattice_rays(int count) {
    std::vector<Ray> rays = rays_along_axes(count, 0.0f);
    for (Ray& ray : rays) ray.origin = glm::floor(ray.origin);
    return rays;
}

TEST(PublishedRules, AgreeOnKindRays) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.1f, 7));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = kind_rays(20000);
    const auto check = [&](Traversal walk, Rules rules) {
        const Count count = count_wrong(scene, tree, walk, rules, rays);
        // A hit may round to just outside of its leaf's cell even here.
        EXPECT_LE(count.wrong, 20) << info(rules).name << " " << info(walk).name;
        EXPECT_EQ(count.capped, 0) << info(rules).name << " " << info(walk).name;
    };
    for (const Traversal walk : published_walks()) check(walk, Rules::as_published);
    check(Traversal::stack, Rules::first_edition);
}

TEST(PublishedRules, TheFirstEditionsRuleNeedsAStack) {
    // Going on at t_end, `t < t_begin` is never true of the plane that was just met: the same cell again, for ever.
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.1f, 7));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = kind_rays(2000);
    EXPECT_GT(count_wrong(scene, tree, Traversal::restart, Rules::first_edition, rays).capped, 100);
    EXPECT_GT(count_wrong(scene, tree, Traversal::backtrack, Rules::first_edition, rays).capped, 100);
}

TEST(PublishedRules, LoseRaysInsideLatticePlanes) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = lattice_rays(3000);
    for (const Rules rules : {Rules::as_published, Rules::first_edition})
        for (const Traversal walk : published_walks())
            EXPECT_GT(count_wrong(scene, tree, walk, rules, rays).wrong, 30)
                << info(rules).name << " " << info(walk).name;
}

TEST(PublishedRules, LoseWhatLiesBehindAnOriginOnASplitPlane) {
    // Inside a closed sphere every ray hits, so what is lost is seen.
    const FlatScene scene = test::scene_of(test::stress_sphere(40, 20));
    const KdTree tree = build_tree(scene.triangles, {});
    test::Random random(9);
    std::vector<Ray> rays;
    while (rays.size() < 5000) {
        const TreeNode& node = tree.nodes[std::size_t(random.below(int(tree.nodes.size())))];
        if (node.flag == KD_LEAF || std::abs(node.split) > 0.5f) continue;
        Vec3 o = random.point(-0.4f, 0.4f);
        o[node.flag] = node.split;
        rays.push_back({o, random.point(-1, 1), 0.0f, KD_T_LIMIT, -1});
    }
    for (const Traversal walk : published_walks()) {
        EXPECT_GT(count_wrong(scene, tree, walk, Rules::as_published, rays).wrong, 100) << info(walk).name;
        EXPECT_EQ(count_wrong(scene, tree, walk, Rules::robust, rays).wrong, 0) << info(walk).name;
    }
}

TEST(PublishedRules, RaysAlongAxesAreTheSameForBothZeros) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    const KdTree tree = build_tree(scene.triangles, {});
    for (const float zero : {0.0f, -0.0f})
        for (const Traversal walk : published_walks())
            EXPECT_EQ(count_wrong(scene, tree, walk, Rules::robust, rays_along_axes(3000, zero)).wrong, 0);
}

}  // namespace
}  // namespace kd
