// What all builders share: hard scenes, limits, progress and stopping, refusal of bad input.

#include "renderer/kdtree/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "tests/core/tree_checks.h"
#include "tests/core/tree_samples.h"
#include "tests/support/refusal.h"
#include "tests/support/scenes.h"

namespace kd {

/// How a failing test names its builder.
void PrintTo(const Builder& builder, std::ostream* out) { *out << builder.name; }

namespace {

using test::depth_of;
using test::faults;

TEST(SpatialMedianBuilder, HalvesTheLongestAxis) {
    BuildConfig config;
    config.builder = "spatial-median";
    config.leaf_size = 1;
    KdTree expected = test::two_slab_tree();
    expected.nodes[0].split = 1.0f;
    EXPECT_EQ(build_tree(test::two_slabs(), config), expected);
}

TEST(ObjectMedianBuilder, PutsHalfOfTheTrianglesOnEitherSide) {
    std::vector<Triangle> slabs;
    for (const float x : {0.0f, 1.0f, 2.0f, 100.0f}) slabs.push_back(test::slab(x, x + 0.5f));
    const KdTree tree = build_tree(slabs, {.builder = "object-median", .leaf_size = 2});
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(tree.nodes[0].split, 1.75f) << "between the second and the third of four middles";
    EXPECT_EQ(faults(tree, slabs), "");
    const KdTree halves = build_tree(slabs, {.builder = "spatial-median", .leaf_size = 2});
    EXPECT_EQ(halves.nodes[0].split, 50.25f) << "where the other builder cuts";
}

class EveryBuilder : public testing::TestWithParam<Builder> {
  protected:
    /// Deeper than the defaults, so that the limits come into play.
    EveryBuilder() {
        config_.builder = GetParam().name;
        config_.leaf_size = 1;
        config_.bad_refines = 3;
    }

    KdTree build_sound(const std::vector<Triangle>& triangles) {
        KdTree tree = build_tree(triangles, config_, &report_);
        EXPECT_EQ(faults(tree, triangles), "");
        EXPECT_LE(depth_of(tree), depth_limit(config_, triangles.size()));
        EXPECT_LE(double(tree.references.size()), double(config_.reference_cap) * double(triangles.size()));
        EXPECT_GE(report_.seconds, 0.0);
        return tree;
    }

    BuildConfig config_;
    BuildReport report_;
};

INSTANTIATE_TEST_SUITE_P(All, EveryBuilder, testing::ValuesIn(builders().begin(), builders().end()),
                         [](const testing::TestParamInfo<Builder>& test) {
                             std::string name(test.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(EveryBuilder, NoTriangles) { EXPECT_EQ(build_sound({}), KdTree{}); }

TEST_P(EveryBuilder, OneTriangle) {
    const KdTree tree = build_sound({test::slab(0.0f, 1.0f)});
    EXPECT_EQ(tree.references, std::vector{0});
    EXPECT_EQ(tree.nodes.size(), 1u);
}

TEST_P(EveryBuilder, TrianglesWithoutASurface) {
    build_sound(std::vector<Triangle>(3, {{Vec3(1.0f), Vec3(1.0f), Vec3(1.0f)}}));
    build_sound({{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}}, {{Vec3(3, 0, 0), Vec3(4, 0, 0), Vec3(5, 0, 0)}}});
}

TEST_P(EveryBuilder, CoplanarGrid) {
    const std::vector<Triangle> grid = test::flat_grid(40);
    const KdTree tree = build_sound(grid);
    EXPECT_GT(tree.nodes.size(), grid.size() / 2) << "a flat scene is split like any other";
    for (const TreeNode& node : tree.nodes) EXPECT_NE(node.flag, 2) << "nothing to cut across the plane";
}

TEST_P(EveryBuilder, ChainIsLimitedInDepth) {
    const std::vector<Triangle> chain = test::chain(64);
    EXPECT_EQ(depth_limit(config_, chain.size()), 18);
    build_sound(chain);
    config_.max_depth = max_tree_depth;
    config_.bad_refines = max_tree_depth;
    build_sound(chain);
}

TEST_P(EveryBuilder, DepthLimitIsTold) {
    config_.max_depth = 3;
    EXPECT_EQ(depth_of(build_sound(test::stress_sphere(32, 16))), 3);
    EXPECT_TRUE(report_.depth_limit_hit);
    build_sound(test::two_slabs());
    EXPECT_FALSE(report_.depth_limit_hit);
}

TEST_P(EveryBuilder, LargeOverlapStaysWithinTheCap) {
    // Boxes with corners anywhere in the unit cube: every split doubles references.
    test::Random random(11);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 1000; ++i) triangles.push_back(test::triangle_filling(random.point(0, 1), random.point(0, 1)));
    config_.intersection_cost = 20.0f;
    config_.reference_cap = 8.0f;
    const KdTree tree = build_sound(triangles);
    EXPECT_TRUE(report_.reference_cap_hit);
    EXPECT_GT(tree.references.size(), 2000u) << "the cap leaves room for splits";
}

TEST_P(EveryBuilder, AlmostEqualBoxesStayTogether) {
    test::Random random(12);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 4000; ++i) {
        triangles.push_back(test::triangle_filling(random.point(0.0f, 0.01f), random.point(1.0f, 1.01f)));
    }
    EXPECT_LE(build_sound(triangles).references.size(), 8 * triangles.size());
}

TEST_P(EveryBuilder, HugeTinyAndUnevenCoordinates) {
    const std::vector<Triangle> soup = test::random_soup(300, 0.1f, 13);
    for (const float scale : {1e-38f, 1e-20f, 1e18f, 1e38f}) {
        std::vector<Triangle> scaled = soup;
        for (Triangle& triangle : scaled) {
            for (Vec3& corner : triangle.corner) corner *= scale;
        }
        build_sound(scaled);
    }
    std::vector<Triangle> teapot_in_stadium = soup;
    for (Triangle& triangle : teapot_in_stadium) {
        for (Vec3& corner : triangle.corner) corner *= 1e-3f;
    }
    teapot_in_stadium.push_back(test::triangle_filling(Vec3(-1e4f), Vec3(1e4f, 1e4f, -1e4f)));
    EXPECT_GT(build_sound(teapot_in_stadium).nodes.size(), 3u);
}

TEST_P(EveryBuilder, IsDeterministic) {
    const std::vector<Triangle> soup = test::random_soup(1000, 0.1f, 14);
    EXPECT_EQ(build_tree(soup, config_), build_tree(soup, config_));
}

TEST_P(EveryBuilder, OrderOfTrianglesDoesNotMatter) {
    const std::vector<Triangle> soup = test::random_soup(1000, 0.1f, 15);
    const std::vector<Triangle> reversed(soup.rbegin(), soup.rend());
    const KdTree tree = build_tree(soup, config_);
    const KdTree other = build_tree(reversed, config_);
    EXPECT_EQ(tree.nodes, other.nodes);
    ASSERT_EQ(tree.references.size(), other.references.size());
    for (const TreeNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        for (int k = 0; k < node.count; ++k) {
            const int mirrored = other.references[std::size_t(node.link + node.count - 1 - k)];
            EXPECT_EQ(tree.references[std::size_t(node.link + k)], 999 - mirrored);
        }
    }
}

TEST_P(EveryBuilder, ProgressRisesToOne) {
    const std::vector<Triangle> ball = test::stress_sphere(64, 32);
    std::vector<float> told;
    (void)build_tree(ball, config_, nullptr, [&](float fraction) { told.push_back(fraction); });
    ASSERT_GT(told.size(), 20u);
    EXPECT_LT(told.size(), 200u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GT(told.front(), 0.0f);
    EXPECT_EQ(told.back(), 1.0f);
}

TEST_P(EveryBuilder, StoppedBeforeItBegan) {
    std::stop_source source;
    source.request_stop();
    const std::vector<Triangle> ball = test::stress_sphere(16, 8);
    const KdTree tree = build_tree(ball, config_, nullptr, {}, source.get_token());
    EXPECT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(faults(tree, ball), "");
}

TEST_P(EveryBuilder, StoppedHalfWay) {
    std::stop_source source;
    const std::vector<Triangle> ball = test::stress_sphere(64, 32);
    const auto stop_soon = [&](float fraction) {
        if (fraction > 0.3f) source.request_stop();
    };
    const KdTree tree = build_tree(ball, config_, nullptr, stop_soon, source.get_token());
    EXPECT_EQ(faults(tree, ball), "");
    const std::size_t whole = build_tree(ball, config_).nodes.size();
    EXPECT_GT(tree.nodes.size(), whole / 10);
    EXPECT_LT(tree.nodes.size(), whole * 8 / 10);
}

TEST(Build, IdenticalTrianglesStayInOneLeaf) {
    for (const std::size_t n : {std::size_t(2), std::size_t(10000)}) {
        const std::vector<Triangle> same(n, test::slab(0.0f, 1.0f));
        BuildReport report;
        const KdTree tree = build_tree(same, {}, &report);
        EXPECT_EQ(tree.nodes.size(), 1u);
        EXPECT_EQ(tree.references.size(), n);
        EXPECT_FALSE(report.depth_limit_hit || report.reference_cap_hit);
        EXPECT_EQ(faults(tree, same), "");
    }
}

/// Interior nodes of which at least `share` of the cell, from one face on, lies before or behind all of their
/// triangles, and how many of these have an empty leaf for a child.
std::pair<int, int> emptied(const KdTree& tree, const std::vector<Triangle>& triangles, double share) {
    const std::vector<Aabb> cells = node_boxes(tree);
    std::vector<Aabb> covered(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const TreeNode& n = tree.nodes[i];
        if (n.is_leaf())
            for (int k = 0; k < n.count; ++k) {
                const Aabb box = bounds_of(triangles[std::size_t(tree.references[std::size_t(n.link + k)])]);
                covered[i].include(box.lower);
                covered[i].include(box.upper);
            }
        if (n.parent < 0 || covered[i].empty()) continue;
        covered[std::size_t(n.parent)].include(covered[i].lower);
        covered[std::size_t(n.parent)].include(covered[i].upper);
    }
    int wide = 0, cut = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& n = tree.nodes[i];
        if (n.is_leaf()) continue;
        bool has_margin = false;
        for (int axis = 0; axis < 3; ++axis) {
            const float least = float(share) * (cells[i].upper[axis] - cells[i].lower[axis]);
            has_margin = has_margin || covered[i].lower[axis] - cells[i].lower[axis] > least ||
                         cells[i].upper[axis] - covered[i].upper[axis] > least;
        }
        const auto is_empty = [&](int child) {
            const TreeNode& c = tree.nodes[std::size_t(child)];
            return c.is_leaf() && c.count == 0;
        };
        wide += has_margin;
        cut += has_margin && (is_empty(int(i) + 1) || is_empty(n.link));
    }
    return {wide, cut};
}

TEST_P(EveryBuilder, CutsOffEmptySpaceFirst) {
    const std::vector<Triangle> soup = test::random_soup(300, 0.05f, 8);
    config_.trim_leaves = false;
    const auto [wide_before, cut_before] = emptied(build_sound(soup), soup, 0.26);
    config_.empty_cut = 0.25f;
    const auto [wide, cut] = emptied(build_sound(soup), soup, 0.26);
    EXPECT_GT(wide, 10);
    EXPECT_EQ(cut, wide);
    EXPECT_LT(cut_before, wide_before) << "or the option would change nothing";
}

TEST(Build, NodesOfLeafSizeAreNotSplit) {
    const std::vector<Triangle> ball = test::stress_sphere(32, 16);
    for (const int size : {1, 4, 100}) {
        const KdTree tree = build_tree(ball, {.leaf_size = size, .trim_leaves = false});
        EXPECT_EQ(faults(tree, ball), "");
        for (std::size_t i = 0; i + 2 < tree.nodes.size(); ++i) {
            const TreeNode& below = tree.nodes[i + 1];
            if (tree.nodes[i].is_leaf() || !below.is_leaf() || !tree.nodes[i + 2].is_leaf()) continue;
            // The lists of two sibling leaves stand side by side.
            const auto first = tree.references.begin() + below.link;
            const std::set<int> triangles(first, first + below.count + tree.nodes[i + 2].count);
            EXPECT_GT(triangles.size(), std::size_t(size)) << "node " << i;
        }
    }
    EXPECT_LT(build_tree(ball, {.leaf_size = 100}).nodes.size(), build_tree(ball, {.leaf_size = 4}).nodes.size());
    EXPECT_EQ(build_tree(ball, {.leaf_size = int(ball.size())}).nodes.size(), 1u);
}

TEST(Build, DepthLimitFollowsTheConfig) {
    EXPECT_EQ(depth_limit({}, 0), 8);
    EXPECT_EQ(depth_limit({}, 1), 8);
    EXPECT_EQ(depth_limit({}, 1024), 24);
    EXPECT_EQ(depth_limit({}, std::size_t(1) << 40), max_tree_depth);
    EXPECT_EQ(depth_limit({.max_depth = 5}, 1024), 5);
    EXPECT_EQ(depth_limit({.max_depth = max_tree_depth}, 2), max_tree_depth);
}

std::string refusal(const BuildConfig& config, const std::vector<Triangle>& triangles = {}) {
    return test::refusal([&] { (void)build_tree(triangles, config); });
}

TEST(Build, RefusesConstantsOutOfRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect = [](const BuildConfig& config, const std::string& name, const std::string& range) {
        const std::string message = refusal(config);
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_NE(message.find(range), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
    };
    expect({.traversal_cost = -1.0f}, "traversal_cost is -1", "from 0 to 1000000");
    expect({.traversal_cost = nan}, "traversal_cost is nan", "from 0 to 1000000");
    expect({.intersection_cost = 2e6f}, "intersection_cost is 2000000", "from 0 to 1000000");
    expect({.empty_bonus = 1.5f}, "empty_bonus is 1.5", "from 0 to 1");
    expect({.empty_bonus_gate = -0.5f}, "empty_bonus_gate is -0.5", "from 0 to 1");
    expect({.empty_cut = 1.5f}, "empty_cut is 1.5", "from 0 to 1");
    expect({.leaf_size = -1}, "leaf_size is -1", "from 0 to");
    expect({.max_depth = 65}, "max_depth is 65", "from 0 to 64");
    expect({.bad_refines = -1}, "bad_refines is -1", "from 0 to 64");
    expect({.bins = 3}, "bins is 3", "from 4 to 256");
    expect({.bins = 257}, "bins is 257", "from 4 to 256");
    expect({.reference_cap = 0.5f}, "reference_cap is 0.5", "from 1 to");
    EXPECT_EQ(refusal({}), "accepted");
}

TEST(Build, UnknownBuilderNamesTheKnownOnes) {
    const std::string message = refusal({.builder = "best"});
    EXPECT_NE(message.find("'best'"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
    for (const Builder& builder : builders())
        EXPECT_NE(message.find(builder.name), std::string::npos) << builder.name << " is not offered: " << message;
    EXPECT_EQ(find_builder("best"), nullptr);
    ASSERT_NE(find_builder("paper"), nullptr);
    EXPECT_EQ(find_builder("paper")->name, BuildConfig{}.builder);
}

TEST(Build, RefusesTrianglesThatAreNotFinite) {
    std::vector<Triangle> triangles = test::two_slabs();
    triangles[1].corner[2].y = std::numeric_limits<float>::infinity();
    EXPECT_NE(refusal({}, triangles).find("triangle 1 "), std::string::npos);
    triangles[0].corner[0].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal({}, triangles).find("triangle 0 "), std::string::npos);
}

}  // namespace
}  // namespace kd
