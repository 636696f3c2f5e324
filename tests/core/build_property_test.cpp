// What must hold for every tree, whatever the triangles and the configuration.

#ifdef KD_WITH_RAPIDCHECK

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/clip.h"
#include "renderer/kdtree/encode.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/sah.h"
#include "renderer/kdtree/stats.h"
#include "tests/core/tree_checks.h"

namespace kd {
namespace {

using test::depth_of;
using test::faults;

rc::Gen<BuildConfig> any_config() {
    const auto real = [](int low, int high, float scale) {
        return rc::gen::map(rc::gen::inRange(low, high), [=](int n) { return float(n) * scale; });
    };
    const auto name = rc::gen::map(rc::gen::inRange<std::size_t>(0, builders().size()),
                                   [](std::size_t i) { return std::string(builders()[i].name); });
    return rc::gen::build<BuildConfig>(rc::gen::set(&BuildConfig::builder, name),
                                       rc::gen::set(&BuildConfig::traversal_cost, real(0, 40, 0.25f)),
                                       rc::gen::set(&BuildConfig::intersection_cost, real(0, 400, 0.25f)),
                                       rc::gen::set(&BuildConfig::empty_bonus, real(0, 9, 0.125f)),
                                       rc::gen::set(&BuildConfig::empty_bonus_gate, real(0, 9, 0.125f)),
                                       rc::gen::set(&BuildConfig::leaf_size, rc::gen::inRange(0, 8)),
                                       rc::gen::set(&BuildConfig::max_depth, rc::gen::inRange(0, 20)),
                                       rc::gen::set(&BuildConfig::bad_refines, rc::gen::inRange(0, 8)),
                                       rc::gen::set(&BuildConfig::reference_cap, real(4, 80, 0.25f)),
                                       rc::gen::set(&BuildConfig::bins, rc::gen::inRange(fewest_bins, most_bins + 1)),
                                       rc::gen::set(&BuildConfig::trim_leaves, rc::gen::arbitrary<bool>()));
}

/// Triangles with the given coordinates: coarse ones share planes, points and edges often.
rc::Gen<std::vector<Triangle>> triangles_of(const rc::Gen<float>& coordinate) {
    const auto corner =
        rc::gen::apply([](float x, float y, float z) { return Vec3(x, y, z); }, coordinate, coordinate, coordinate);
    const auto triangle = rc::gen::apply(
        [](Vec3 a, Vec3 b, Vec3 c) {
            return Triangle{{a, b, c}};
        },
        corner, corner, corner);
    return rc::gen::container<std::vector<Triangle>>(triangle);
}

rc::Gen<float> coarse_coordinate() {
    return rc::gen::map(rc::gen::inRange(-4, 5), [](int n) { return float(n) * 0.5f; });
}

/// Magnitudes from 2^-140 (a denormal number) to 2^120, both zeros among them.
rc::Gen<float> stiff_coordinate() {
    return rc::gen::apply([](int n, int exponent) { return std::ldexp(float(n), exponent); }, rc::gen::inRange(-9, 10),
                          rc::gen::element(-140, -20, -1, 0, 1, 20, 120));
}

void check_everything(const std::vector<Triangle>& triangles, const BuildConfig& config) {
    const KdTree tree = build_tree(triangles, config);
    RC_ASSERT(faults(tree, triangles) == "");  // every triangle referenced, depth-first order, splits inside
    RC_ASSERT(depth_of(tree) <= depth_limit(config, triangles.size()));
    RC_ASSERT(double(tree.references.size()) <= double(config.reference_cap) * double(triangles.size()));
    RC_ASSERT(decode_float4(encode_float4(tree), tree.references, tree.bounds) == tree);
    RC_ASSERT(decode_packed(encode_packed(tree), tree.references, tree.bounds) == tree);
    const TreeStats stats = tree_stats(tree, triangles.size(), config);
    RC_ASSERT(std::isfinite(stats.sah_cost));
    for (const TreeNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        const auto first = tree.references.begin() + node.link;
        RC_ASSERT(std::is_sorted(first, first + node.count));
    }
}

/// The triangles below each node: leaf lists of a subtree stand side by side.
std::vector<std::set<int>> triangles_below(const KdTree& tree) {
    std::vector<std::set<int>> sets(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const TreeNode& node = tree.nodes[i];
        if (node.is_leaf()) {
            const auto first = tree.references.begin() + node.link;
            sets[i].insert(first, first + node.count);
        } else {
            sets[i] = sets[i + 1];
            sets[i].insert(sets[std::size_t(node.link)].begin(), sets[std::size_t(node.link)].end());
        }
    }
    return sets;
}

/// Cost of cutting a cell at a place, by counting; the side of the triangles in the plane is the better one.
double counted_cost(const SplitCost& cost, const std::vector<Aabb>& boxes, int axis, float position) {
    int below = 0, above = 0, planar = 0;
    for (const Aabb& box : boxes) {
        if (box.lower[axis] == position && box.upper[axis] == position) ++planar;
        below += box.lower[axis] < position;
        above += box.upper[axis] > position;
    }
    return std::min(cost(position, below + planar, above), cost(position, below, above + planar));
}

/// Least cost of cutting a cell across an axis at any start or end of a box strictly inside it.
double least_cost(const BuildConfig& config, const Aabb& cell, const std::vector<Aabb>& boxes, int axis) {
    const SplitCost cost(config, cell, axis);
    double least = std::numeric_limits<double>::infinity();
    for (const Aabb& box : boxes) {
        for (const float position : {box.lower[axis], box.upper[axis]}) {
            if (position <= cell.lower[axis] || position >= cell.upper[axis]) continue;
            least = std::min(least, counted_cost(cost, boxes, axis, position));
        }
    }
    return least;
}

/// Boxes of triangles by their numbers.
using Boxes = std::map<int, Aabb>;

Boxes boxes_of(const std::vector<Triangle>& triangles, const std::set<int>& numbers) {
    Boxes boxes;
    for (const int t : numbers) boxes[t] = bounds_of(triangles[std::size_t(t)]);
    return boxes;
}

/// What the boxes of a node's triangles become in its child below (0) or above (1): cut triangles are clipped.
Boxes clipped_boxes(const std::vector<Triangle>& triangles, const Boxes& whole, const std::set<int>& numbers,
                    const TreeNode& parent, const Aabb& cell, std::size_t side) {
    Boxes boxes;
    for (const int t : numbers) {
        const Aabb box = whole.at(t);
        const bool is_cut = box.lower[parent.flag] < parent.split && parent.split < box.upper[parent.flag];
        boxes[t] = is_cut ? clipped_halves(triangles[std::size_t(t)], cell, parent.flag, parent.split, box)[side] : box;
    }
    return boxes;
}

/// How a builder that sweeps chooses.
struct SweepRule {
    std::string builder;
    bool longest_first = false;  // other axes only where the longest does not pay
    bool clips = false;
};

/// Every split is the one that the rule asks for, found again by trying all.
void check_choices(const std::vector<Triangle>& triangles, BuildConfig config, const SweepRule& rule) {
    config.builder = rule.builder;
    config.trim_leaves = false;  // the costs go by boxes
    const KdTree tree = build_tree(triangles, config);
    const std::vector<Aabb> cells = node_boxes(tree);
    const std::vector<std::set<int>> inside = triangles_below(tree);
    std::vector<Boxes> boxes(tree.nodes.size());
    boxes[0] = boxes_of(triangles, inside[0]);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        if (node.is_leaf()) continue;
        std::vector<Aabb> here;
        for (const auto& [number, box] : boxes[i]) here.push_back(box);
        double expected = least_cost(config, cells[i], here, longest_axis(cells[i]));
        if (!rule.longest_first || !(expected < leaf_cost(config, int(here.size()))))
            for (int axis = 0; axis < 3; ++axis)
                expected = std::min(expected, least_cost(config, cells[i], here, axis));
        RC_ASSERT(counted_cost(SplitCost(config, cells[i], node.flag), here, node.flag, node.split) == expected);

        for (const std::size_t side : {0u, 1u}) {
            const std::size_t child = side == 0 ? i + 1 : std::size_t(node.link);
            boxes[child] = rule.clips ? clipped_boxes(triangles, boxes[i], inside[child], node, cells[i], side)
                                      : boxes_of(triangles, inside[child]);
        }
    }
}

RC_GTEST_PROP(BuildProperty, PaperSplitsAreTheCheapest, ()) {
    check_choices(*triangles_of(coarse_coordinate()), *any_config(), {.builder = "paper", .longest_first = true});
}

RC_GTEST_PROP(BuildProperty, ExactSplitsAreTheCheapestOfTheParts, ()) {
    check_choices(*triangles_of(coarse_coordinate()), *any_config(), {.builder = "exact", .clips = true});
}

RC_GTEST_PROP(BuildProperty, BinnedSplitsOfSmallCellsAreTheCheapest, ()) {
    BuildConfig config = *any_config();
    config.bins = most_bins;
    const std::vector<Triangle> triangles = *triangles_of(coarse_coordinate());
    RC_PRE(triangles.size() <= std::size_t(most_bins));
    check_choices(triangles, config, {.builder = "binned"});
}

RC_GTEST_PROP(BuildProperty, HoldsForCoarseTriangles, ()) {
    check_everything(*triangles_of(coarse_coordinate()), *any_config());
}

RC_GTEST_PROP(BuildProperty, HoldsForStiffTriangles, ()) {
    check_everything(*triangles_of(stiff_coordinate()), *any_config());
}

}  // namespace
}  // namespace kd

#endif
