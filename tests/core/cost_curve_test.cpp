// What cell_costs() says of a node, found again by looking at every triangle, and by asking every builder for its tree.

#include "renderer/kdtree/cost_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "renderer/kdtree/clip.h"
#include "renderer/kdtree/hand_split.h"
#include "renderer/kdtree/sah.h"
#include "renderer/scene/procedural.h"
#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

struct Sample {
    const char* name;
    std::vector<Triangle> triangles;
};

/// Curved, axis-parallel with triangles in the planes, and disordered.
std::vector<Sample> samples() {
    return {{"sphere", test::stress_sphere(24, 12)},
            {"city", test::voxel_city(4)},
            {"soup", test::random_soup(200, 0.3f, 5)},
            {"plane", test::flat_grid(8)}};
}

std::vector<Aabb> parts_in(const CellCosts& costs, const std::vector<Triangle>& triangles) {
    std::vector<Aabb> parts;
    for (const std::int32_t n : costs.triangles) {
        const Triangle& triangle = triangles[std::size_t(n)];
        const Aabb box = bounds_of(triangle);
        parts.push_back(clipped_bounds(triangle, costs.cell,
                                       {glm::max(box.lower, costs.cell.lower), glm::min(box.upper, costs.cell.upper)}));
    }
    return parts;
}

void expect_curve(const CellCosts& costs, int axis, const std::vector<Aabb>& parts, const BuildConfig& config) {
    std::set<float> ends;
    for (const Aabb& part : parts)
        for (const float end : {part.lower[axis], part.upper[axis]})
            if (end > costs.cell.lower[axis] && end < costs.cell.upper[axis]) ends.insert(end);
    const std::vector<SplitCandidate>& curve = costs.curves[std::size_t(axis)];
    ASSERT_EQ(curve.size(), ends.size());
    auto end = ends.begin();
    for (const SplitCandidate& candidate : curve) {
        ASSERT_EQ(candidate.position, *end++);
        const auto starts_below = [&](const Aabb& part) { return part.lower[axis] < candidate.position; };
        const auto ends_above = [&](const Aabb& part) { return part.upper[axis] > candidate.position; };
        const int below = int(std::ranges::count_if(parts, starts_below));
        const int above = int(std::ranges::count_if(parts, ends_above));
        const int planar = int(
            std::ranges::count_if(parts, [&](const Aabb& part) { return !starts_below(part) && !ends_above(part); }));
        const SplitCost cost(config, costs.cell, axis);
        const double with_below = cost(candidate.position, below + planar, above);
        const double with_above = cost(candidate.position, below, above + planar);
        EXPECT_EQ(candidate.cost, std::min(with_below, with_above));
        EXPECT_EQ(candidate.below, with_above < with_below ? below : below + planar);
        EXPECT_EQ(candidate.above, with_above < with_below ? above + planar : above);
    }
}

TEST(CellCosts, CurvesAreWhatEveryTriangleSays) {
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.name);
        const BuildConfig config{.leaf_size = 1};
        const KdTree tree = build_tree(sample.triangles, config);
        const std::vector<Aabb> boxes = node_boxes(tree);
        const std::vector<int> depths = node_depths(tree);
        for (int node = 0; node < int(tree.nodes.size()); node += 1 + node / 8) {
            const CellCosts costs = cell_costs(sample.triangles, tree, node, config);
            EXPECT_EQ(costs.node, node);
            EXPECT_EQ(costs.depth, depths[std::size_t(node)]);
            EXPECT_EQ(costs.cell.lower, boxes[std::size_t(node)].lower);
            EXPECT_EQ(costs.cell.upper, boxes[std::size_t(node)].upper);
            EXPECT_EQ(costs.leaf_cost, double(config.intersection_cost) * double(costs.triangles.size()));
            const std::vector<Aabb> parts = parts_in(costs, sample.triangles);
            if (costs.cell.surface_area() > 0.0)
                for (int axis = 0; axis < 3; ++axis) expect_curve(costs, axis, parts, config);
        }
    }
}

TEST(CellCosts, TrianglesAreThoseOfTheLeavesBelow) {
    const std::vector<Triangle> soup = test::random_soup(60, 0.4f, 6);
    const KdTree tree = build_tree(soup, {});
    for (int node = 0; node < int(tree.nodes.size()); ++node) {
        const std::string path = node_path(tree, node);
        std::set<std::int32_t> below;
        for (int i = 0; i < int(tree.nodes.size()); ++i) {
            const TreeNode& leaf = tree.nodes[std::size_t(i)];
            if (!leaf.is_leaf() || !node_path(tree, i).starts_with(path)) continue;
            for (int k = 0; k < leaf.count; ++k) below.insert(tree.references[std::size_t(leaf.link + k)]);
        }
        EXPECT_EQ(cell_costs(soup, tree, node, {}).triangles, std::vector(below.begin(), below.end()));
    }
}

const BuilderChoice& choice_of(const CellCosts& costs, const std::string& builder) {
    return *std::ranges::find(costs.choices, builder, &BuilderChoice::builder);
}

/// The tree's own builder names the tree's own plane, or, where bad refines have not run out, its leaf.
void expect_own_choice(const Sample& sample, const BuildConfig& config) {
    const KdTree tree = build_tree(sample.triangles, config);
    for (int node = 0; node < int(tree.nodes.size()); node += 1 + node / 16) {
        SCOPED_TRACE(config.builder + ", " + sample.name + ", node '" + node_path(tree, node) + "'");
        const CellCosts costs = cell_costs(sample.triangles, tree, node, config);
        const TreeNode& n = tree.nodes[std::size_t(node)];
        if (!(costs.cell.surface_area() > 0.0)) continue;
        ASSERT_EQ(costs.choices.size(), builders().size());
        const BuilderChoice& own = choice_of(costs, config.builder);
        ASSERT_EQ(costs.chosen.has_value(), !n.is_leaf());
        if (n.is_leaf()) {
            EXPECT_EQ(costs.chosen_cost, costs.leaf_cost);
            EXPECT_TRUE(!own.split || own.split->bad || costs.depth == depth_limit(config, sample.triangles.size()));
            continue;
        }
        ASSERT_TRUE(own.split);
        EXPECT_EQ(own.split->axis, n.flag);
        EXPECT_EQ(own.split->position, n.split);
        EXPECT_EQ(costs.chosen->axis, n.flag);
        EXPECT_EQ(costs.chosen->position, n.split);
        EXPECT_EQ(costs.chosen_cost, own.cost);
    }
}

TEST(CellCosts, TheTreesBuilderNamesTheTreesPlane) {
    for (const Sample& sample : samples())
        for (const Builder& builder : builders())
            for (const float cut : {0.0f, 0.25f}) {
                BuildConfig config{.builder = std::string(builder.name), .empty_cut = cut, .bad_refines = 2};
                expect_own_choice(sample, config);
            }
}

TEST(CellCosts, APlaneByHandIsChosenButNoBuildersChoice) {
    const std::vector<Triangle> city = test::voxel_city(4);
    for (const Builder& builder : builders()) {
        SCOPED_TRACE(builder.name);
        BuildConfig config{.builder = std::string(builder.name)};
        const KdTree free = build_tree(city, config);
        const Aabb& bounds = free.bounds;
        // A face of the first box has triangles that lie in the plane.
        const float position = city[0].corner[0].x > bounds.lower.x ? city[0].corner[0].x : 0.4f * bounds.upper.x;
        config.by_hand = {{"", 0, position}};
        const KdTree tree = build_tree(city, config);
        const CellCosts root = cell_costs(city, tree, 0, config);
        EXPECT_EQ(root.chosen->position, position);
        EXPECT_EQ(choice_of(root, config.builder).split->position, free.nodes[0].split);
        for (const int node : {1, tree.nodes[0].link}) {
            ASSERT_FALSE(tree.nodes[std::size_t(node)].is_leaf());
            const CellCosts costs = cell_costs(city, tree, node, config);
            EXPECT_EQ(choice_of(costs, config.builder).split->position, tree.nodes[std::size_t(node)].split);
        }
    }
}

TEST(CellCosts, AStopLeavesPartsOut) {
    std::stop_source stop;
    stop.request_stop();
    const std::vector<Triangle> soup = test::random_soup(60, 0.4f, 6);
    const KdTree tree = build_tree(soup, {});
    EXPECT_TRUE(cell_costs(soup, tree, 0, {}, stop.get_token()).choices.empty());
}

}  // namespace
}  // namespace kd
