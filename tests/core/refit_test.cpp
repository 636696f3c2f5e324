// Trees of moved triangles with the planes of an earlier tree.
#include "renderer/kdtree/refit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/cell.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/stats.h"
#include "renderer/scene/moving_scene.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/core/tree_checks.h"
#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::faults;

std::vector<Hit> hits_of(const FlatScene& scene, const KdTree& tree, Traversal traversal,
                         const std::vector<Ray>& rays) {
    CpuTracer tracer(scene, tree);
    TraceConfig config;
    config.traversal = traversal;
    std::vector<Hit> hits(rays.size());
    tracer.trace_rays(config, rays, false, hits, {});
    return hits;
}

void expect_right_hits(const FlatScene& scene, const KdTree& tree) {
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 600, 4);
    const std::vector<Hit> exact = hits_of(scene, tree, Traversal::naive, rays);
    for (const TraversalInfo& walk : traversals()) {
        const std::vector<Hit> found = hits_of(scene, tree, walk.id, rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_TRUE(bit_equal(found[i], exact[i])) << walk.name << " " << test::hex(rays[i]);
    }
}

BuildConfig with_builder(std::string_view name) { return {.builder = std::string(name)}; }

TEST(Refit, AtItsOwnTimeATreeStaysAsItIs) {
    const MovingScene scene(*make_procedural("sheet:6000"));
    const std::vector<Triangle>& triangles = scene.at_rest().triangles;
    for (const Builder& builder : builders()) {
        const KdTree tree = build_tree(triangles, with_builder(builder.name));
        const auto again = refit_tree(tree, triangles.size(), triangles, with_builder(builder.name));
        ASSERT_TRUE(again) << builder.name;
        // Nothing of the sheet lies in a plane; clipping leaves fewer triangles in a cell than boxes do, but leaves are
        // trimmed.
        EXPECT_EQ(*again, tree) << builder.name;
    }
}

TEST(Refit, TheTreesOfAMovingSheetAreSoundAndFindEveryHit) {
    const MovingScene scene(*make_procedural("sheet:1500"));
    for (const char* builder : {"exact", "binned", "paper"}) {
        const BuildConfig config = with_builder(builder);
        const KdTree first = build_tree(scene.at_rest().triangles, config);
        for (const double seconds : {0.2, 1.0, 1.9, 3.5}) {
            SCOPED_TRACE(std::string(builder) + " at " + std::to_string(seconds));
            const FlatScene moved = scene.at(seconds);
            RefitReport report;
            const auto tree =
                refit_tree(first, moved.triangles.size(), moved.triangles, config, {.most_growth = 10}, &report);
            ASSERT_TRUE(tree) << report.why_none;
            EXPECT_EQ(faults(*tree, moved.triangles), "");
            EXPECT_EQ(tree->bounds.lower, build_tree(moved.triangles, config).bounds.lower);
            expect_right_hits(moved, *tree);
        }
    }
}

TEST(Refit, QualityIsLostAsTheSheetMoves) {
    const MovingScene scene(*make_procedural("sheet:6000"));
    const BuildConfig config = with_builder("exact");
    const KdTree first = build_tree(scene.at_rest().triangles, config);
    const FlatScene moved = scene.at(1.0);
    const auto tree = refit_tree(first, moved.triangles.size(), moved.triangles, config, {.most_growth = 10});
    ASSERT_TRUE(tree);
    const auto cost = [&](const KdTree& of) { return tree_stats(of, moved.triangles.size(), config).sah_cost; };
    EXPECT_GT(cost(*tree), 1.02 * cost(build_tree(moved.triangles, config)));
}

TEST(Refit, PlanesOutsideOfTheNewBoundsGoWithWhatLiesBehindThem) {
    const std::vector<Triangle> wide = test::random_soup(800, 0.1f, 3);
    const BuildConfig config = with_builder("exact");
    const KdTree tree = build_tree(wide, config);
    std::vector<Triangle> narrow = wide;  // all in a quarter of the space
    for (Triangle& triangle : narrow)
        for (Vec3& corner : triangle.corner) corner = 0.25f * corner;
    const auto refitted = refit_tree(tree, wide.size(), narrow, config, {.most_growth = 100});
    ASSERT_TRUE(refitted);
    EXPECT_LT(refitted->nodes.size(), tree.nodes.size());
    EXPECT_EQ(faults(*refitted, narrow), "");
    expect_right_hits(test::scene_of(narrow), *refitted);

    for (Triangle& triangle : narrow)  // and none of it left
        for (Vec3& corner : triangle.corner) corner += Vec3(100.0f, 0.0f, 0.0f);
    const auto far = refit_tree(tree, wide.size(), narrow, config, {.most_growth = 100});
    ASSERT_TRUE(far);
    EXPECT_EQ(faults(*far, narrow), "");
}

TEST(Refit, OfAPlaneOutsideTheSideWithTheTrianglesStays) {
    const auto slabs_at = [](const std::array<float, 4>& positions) {
        std::vector<Triangle> slabs;
        for (const float x : positions) slabs.push_back(test::slab(x, x + 0.5f));
        return slabs;
    };
    const BuildConfig config{.builder = "object-median", .leaf_size = 1};
    const std::vector<Triangle> apart = slabs_at({0, 1, 2, 3});
    const KdTree tree = build_tree(apart, config);
    ASSERT_EQ(tree.nodes.size(), 7u);
    ASSERT_GT(tree.nodes[0].split, 1.5f) << "and planes below and above it";
    const auto up = refit_tree(tree, 4, slabs_at({2, 2, 2, 3}), config, {.most_growth = 10});
    const auto down = refit_tree(tree, 4, slabs_at({0, 1, 1, 1}), config, {.most_growth = 10});
    ASSERT_TRUE(up && down);
    ASSERT_EQ(up->nodes.size(), 3u);
    ASSERT_EQ(down->nodes.size(), 3u);
    EXPECT_EQ(up->nodes[0].split, tree.nodes[std::size_t(tree.nodes[0].link)].split);
    EXPECT_EQ(down->nodes[0].split, tree.nodes[1].split);
}

TEST(Refit, WhereTheTopologyDoesNotAllowItSaysWhy) {
    const std::vector<Triangle> soup = test::random_soup(2000, 0.02f, 3);
    const BuildConfig config = with_builder("exact");
    const KdTree tree = build_tree(soup, config);
    RefitReport report;
    EXPECT_FALSE(refit_tree(tree, soup.size() - 1, soup, config, {}, &report));
    EXPECT_EQ(report.why_none, "the earlier tree is of 1999 triangles, not 2000");
    std::vector<Triangle> large = soup;
    for (Triangle& triangle : large) triangle.corner[1] += Vec3(0.5f, 0.4f, 0.3f);
    EXPECT_FALSE(refit_tree(tree, soup.size(), large, config, {}, &report));
    EXPECT_EQ(report.why_none, "its leaves would name more than 1.5 times as many triangles");
    EXPECT_TRUE(refit_tree(tree, soup.size(), large, config, {.most_growth = 1000}, &report));
    EXPECT_EQ(report.why_none, "");

    std::vector<Triangle> bad = soup;
    bad[7].corner[0].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW((void)refit_tree(tree, soup.size(), bad, config), InputError);
}

TEST(Refit, EdgesOfItsRange) {
    const KdTree none = build_tree({}, {});
    EXPECT_EQ(refit_tree(none, 0, {}, {}), none);
    const std::vector<Triangle> slabs = test::two_slabs();
    const KdTree two = build_tree(slabs, {.builder = "spatial-median", .leaf_size = 1});
    EXPECT_EQ(refit_tree(two, slabs.size(), slabs, {.leaf_size = 1}), two);
    std::stop_source stop;
    stop.request_stop();
    const std::vector<Triangle> soup = test::random_soup(300, 0.1f, 3);
    const auto stopped =
        refit_tree(build_tree(soup, {}), soup.size(), soup, {}, {.most_growth = 10}, nullptr, stop.get_token());
    ASSERT_TRUE(stopped);
    EXPECT_EQ(faults(*stopped, soup), "");
}

TEST(Refit, TheTreeIsTheSameForAnyNumberOfThreads) {
    const std::vector<Triangle> soup = test::random_soup(int(3 * part_size), 0.05f, 21);
    std::vector<Triangle> moved = soup;
    for (std::size_t i = 0; i < moved.size(); ++i)
        for (Vec3& corner : moved[i].corner) corner.x += 0.05f * std::sin(float(i));
    const BuildConfig config = with_builder("binned");
    const KdTree tree = build_tree(soup, config);
    const auto one = refit_tree(tree, soup.size(), moved, config, {}, nullptr, {}, 1);
    ASSERT_TRUE(one);
    EXPECT_EQ(faults(*one, moved), "");
    EXPECT_EQ(refit_tree(tree, soup.size(), moved, config, {}, nullptr, {}, 4), one);
}

}  // namespace
}  // namespace kd
