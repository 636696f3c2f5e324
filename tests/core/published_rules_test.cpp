// Walks as published: right on kind rays, wrong where the literature and our measurements say, never endless unseen.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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

/// However early a walk is ended, it says so, or answers as the whole walk does.
TEST(PublishedRules, AnEndedWalkIsFlagged) {
    const FlatScene scene = test::scene_of(test::random_soup(200, 0.1f, 7));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = kind_rays(300);
    std::vector<Hit> whole(rays.size()), ended(rays.size());
    std::vector<RayCounters> counters(rays.size());
    for (const Traversal walk : published_walks())
        for (const Rules rules : {Rules::robust, Rules::as_published, Rules::first_edition}) {
            TraceConfig config;
            config.traversal = walk;
            config.rules = rules;
            CpuTracer(scene, tree).trace_rays(config, rays, false, whole, {});
            int flagged = 0;
            for (config.step_budget = 1; config.step_budget <= 150; ++config.step_budget) {
                CpuTracer(scene, tree).trace_rays(config, rays, false, ended, counters);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const bool told = counters[i].exit_reason == KD_EXIT_STEP_CAP;
                    flagged += told;
                    ASSERT_TRUE(told || bit_equal(ended[i], whole[i]))
                        << info(walk).name << " " << info(rules).name << ", " << config.step_budget << " steps, ray "
                        << i;
                }
            }
            EXPECT_GT(flagged, 1000) << info(walk).name;
        }
}

TEST(PublishedRules, AgreeOnKindRays) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.1f, 7));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = kind_rays(20000);
    const auto check = [&](Traversal walk, Rules rules) {
        const Count count = count_wrong(scene, tree, walk, rules, rays);
        // A hit may round to just outside of its leaf's cell even here; of these rays none does.
        EXPECT_EQ(count.wrong, 0) << info(rules).name << " " << info(walk).name;
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

struct LeafHit {
    int triangle = -1;
    double t = 0;
};

/// The hit of one triangle in double precision (Moeller, Trumbore 1997); none: triangle -1.
LeafHit hit_of(const FlatScene& scene, int triangle, const Ray& ray) {
    const auto& corner = scene.triangles[std::size_t(triangle)].corner;
    const glm::dvec3 o(ray.origin), d(ray.direction), a(corner[0]);
    const glm::dvec3 ab = glm::dvec3(corner[1]) - a, ac = glm::dvec3(corner[2]) - a, p = glm::cross(d, ac);
    const double scale = glm::dot(ab, p);
    const glm::dvec3 q = glm::cross(o - a, ab);
    const double u = glm::dot(o - a, p) / scale, v = glm::dot(d, q) / scale, t = glm::dot(ac, q) / scale;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? LeafHit{triangle, t} : LeafHit{};
}

/// What is taken for the nearest hit where a walk ends in the first leaf that holds one.
enum class LeafRule { first_of_list, nearest_of_list, nearest_in_cell };

LeafHit first_in_leaves(const FlatScene& scene, const KdTree& tree, const std::vector<Aabb>& boxes, const Ray& ray,
                        LeafRule rule) {
    struct Entered {
        double begin, end;
        const TreeNode* leaf;
    };
    std::vector<Entered> way;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (!tree.nodes[i].is_leaf()) continue;
        const glm::dvec3 o(ray.origin), d(ray.direction);
        const glm::dvec3 a = (glm::dvec3(boxes[i].lower) - o) / d, b = (glm::dvec3(boxes[i].upper) - o) / d;
        const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
        const double begin = std::max({near.x, near.y, near.z, 0.0}), end = std::min({far.x, far.y, far.z});
        if (begin <= end) way.push_back({begin, end, &tree.nodes[i]});
    }
    std::ranges::sort(way, {}, &Entered::begin);
    for (const Entered& cell : way) {
        LeafHit found;
        for (int i = 0; i < cell.leaf->count; ++i) {
            const LeafHit hit = hit_of(scene, tree.references[std::size_t(cell.leaf->link + i)], ray);
            if (hit.triangle < 0 || (rule == LeafRule::nearest_in_cell && hit.t > cell.end + 1e-9)) continue;
            if (found.triangle < 0 || (rule != LeafRule::first_of_list && hit.t < found.t)) found = hit;
        }
        if (found.triangle >= 0) return found;
    }
    return {};
}

TEST(PublishedRules, TheFirstIntersectionIsTheNearestOfItsCellAlone) {
    // "The kd-tree guarantees that the first intersection will always be the nearest" (2.3.2): not the first of a
    // leaf's list, and not the nearest of it either, for a triangle reaches into cells that lie behind nearer ones.
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.5f, 7));
    BuildConfig config;
    config.leaf_size = 8;
    const KdTree tree = build_tree(scene.triangles, config);
    const std::vector<Aabb> boxes = node_boxes(tree);
    std::array<int, 3> wrong{};
    for (const Ray& ray : kind_rays(5000)) {
        LeafHit nearest;
        for (int i = 0; i < int(scene.triangles.size()); ++i)
            if (const LeafHit hit = hit_of(scene, i, ray); hit.triangle >= 0)
                if (nearest.triangle < 0 || hit.t < nearest.t) nearest = hit;
        for (const LeafRule rule : {LeafRule::first_of_list, LeafRule::nearest_of_list, LeafRule::nearest_in_cell})
            wrong[std::size_t(rule)] += first_in_leaves(scene, tree, boxes, ray, rule).triangle != nearest.triangle;
    }
    EXPECT_GT(wrong[std::size_t(LeafRule::first_of_list)], 200);
    EXPECT_GT(wrong[std::size_t(LeafRule::nearest_of_list)], 40);
    EXPECT_LT(wrong[std::size_t(LeafRule::nearest_of_list)], wrong[std::size_t(LeafRule::first_of_list)]);
    EXPECT_EQ(wrong[std::size_t(LeafRule::nearest_in_cell)], 0);
}

TEST(PublishedRules, WhichChildIsVisitedAloneDependsOnTheOrigin) {
    // Figures 6 and 7 say "the left child" and "the right child": so it is for origins on the left alone.
    const Triangle left{{Vec3(-1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, 0, 1)}};
    const Triangle right{{Vec3(1, -1, -1), Vec3(1, 1, -1), Vec3(1, 0, 1)}};
    const FlatScene scene = test::scene_of({left, right});
    BuildConfig config;
    config.builder = "spatial-median";
    config.leaf_size = 1;
    config.intersection_cost = 100;  // worth a cut
    const KdTree tree = build_tree(scene.triangles, config);
    ASSERT_EQ(tree.nodes.front().flag, 0) << "cut across x";
    CpuTracer tracer(scene, tree);
    TraceConfig published;
    published.rules = Rules::as_published;
    for (const float side : {-1.0f, 1.0f}) {
        // Away from the plane that cuts the scene, the other child is never visited.
        const std::vector<Ray> rays{{Vec3(0.5f * side, 0, 0), Vec3(side, 0.01f, 0.01f), 0.0f, KD_T_LIMIT, -1}};
        std::vector<Hit> hits(1);
        std::vector<RayCounters> counters(1);
        tracer.trace_rays(published, rays, false, hits, counters);
        EXPECT_EQ(hits[0].triangle, side < 0 ? 0 : 1);
        EXPECT_EQ(counters[0].leaves, 1);
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
