// Planes put by hand: they stand where they were put, whatever the builder, and the rest of the tree stays.

#include "renderer/kdtree/hand_split.h"

#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "tests/core/tree_checks.h"
#include "tests/core/tree_samples.h"
#include "tests/support/refusal.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::faults;

struct Built {
    KdTree tree;
    BuildReport report;
};

Built build(const std::vector<Triangle>& triangles, std::string_view builder, std::vector<HandSplit> by_hand,
            BuildConfig config = {}) {
    config.builder = builder;
    config.by_hand = std::move(by_hand);
    Built built;
    built.tree = build_tree(triangles, config, &built.report);
    EXPECT_EQ(faults(built.tree, triangles), "") << builder;
    return built;
}

/// A node with its subtree, its links counted from the node, with the triangles of its leaves.
struct Subtree {
    std::vector<TreeNode> nodes;
    std::vector<std::int32_t> references;
    bool operator==(const Subtree&) const = default;
};

Subtree subtree(const KdTree& tree, int node) {
    int last = node;
    while (!tree.nodes[std::size_t(last)].is_leaf()) last = tree.nodes[std::size_t(last)].link;
    Subtree cut;
    for (int i = node; i <= last; ++i) {
        TreeNode n = tree.nodes[std::size_t(i)];
        n.parent -= node;
        if (n.is_leaf()) {
            const auto first = tree.references.begin() + n.link;
            n.link = int(cut.references.size());
            cut.references.insert(cut.references.end(), first, first + n.count);
        } else {
            n.link -= node;
        }
        cut.nodes.push_back(n);
    }
    cut.nodes[0].parent = -1;
    return cut;
}

class HandSplits : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(EveryBuilder, HandSplits, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const Builder& builder : builders()) names.emplace_back(builder.name);
                             return names;
                         }()));

TEST_P(HandSplits, StandWhereTheyArePut) {
    const std::vector<Triangle> sphere = test::stress_sphere(24, 12);
    const Built built = build(sphere, GetParam(), {{"", 2, 0.125f}, {"ab", 0, -0.25f}, {"b", 1, 0.1f}});
    EXPECT_EQ(built.report.hand_splits, 3);
    EXPECT_EQ(built.report.idle_hand_splits, 0);
    for (const auto& [path, axis, position] : {HandSplit{"", 2, 0.125f}, {"ab", 0, -0.25f}, {"b", 1, 0.1f}}) {
        const TreeNode& node = built.tree.nodes[std::size_t(node_at(built.tree, path).value())];
        EXPECT_EQ(node.flag, axis) << path;
        EXPECT_EQ(node.split, position) << path;
    }
}

TEST_P(HandSplits, LeaveTheRestOfTheTreeAlone) {
    const std::vector<Triangle> sphere = test::stress_sphere(24, 12);
    const KdTree before = build(sphere, GetParam(), {}).tree;
    const int moved = node_at(before, "ba").value();
    const TreeNode& node = before.nodes[std::size_t(moved)];
    ASSERT_FALSE(node.is_leaf());
    const Aabb cell = node_boxes(before)[std::size_t(moved)];
    const float aside = 0.5f * (node.split + cell.upper[node.flag]);
    const KdTree after = build(sphere, GetParam(), {{"ba", node.flag, aside}}).tree;
    ASSERT_NE(after, before);
    for (const char* path : {"bb", "a"})
        EXPECT_EQ(subtree(after, node_at(after, path).value()), subtree(before, node_at(before, path).value())) << path;
    for (const char* path : {"", "b"}) {
        const auto at = [&](const KdTree& tree) { return tree.nodes[std::size_t(node_at(tree, path).value())]; };
        EXPECT_EQ(at(after).flag, at(before).flag);
        EXPECT_EQ(at(after).split, at(before).split);
    }
}

TEST_P(HandSplits, OfTheBuildersOwnPlanesMakeTheSameTree) {
    const std::vector<Triangle> soup = test::random_soup(300, 0.2f, 3);
    const KdTree before = build(soup, GetParam(), {}).tree;
    std::vector<HandSplit> own;
    for (const char* path : {"", "a", "ba"}) {
        const TreeNode& node = before.nodes[std::size_t(node_at(before, path).value())];
        if (!node.is_leaf()) own.push_back({path, node.flag, node.split});
    }
    EXPECT_EQ(build(soup, GetParam(), own).tree, before);
}

TEST_P(HandSplits, LoseNoHit) {
    const FlatScene scene = test::scene_of(test::random_soup(200, 0.4f, 4));
    const Built built =
        build(scene.triangles, GetParam(), {{"", 0, 0.01f}, {"a", 0, 0.02f}, {"b", 1, 0.5f}}, {.empty_cut = 0.2f});
    CpuTracer tracer(scene, built.tree);
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 2000, 9);
    std::vector<Hit> by_tree(rays.size()), by_force(rays.size());
    tracer.trace_rays({}, rays, false, by_tree, {});
    tracer.trace_rays({.traversal = Traversal::naive}, rays, false, by_force, {});
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(by_tree[i].triangle, by_force[i].triangle) << test::hex(rays[i]);
        EXPECT_EQ(by_tree[i].t, by_force[i].t);
    }
}

TEST_P(HandSplits, AreIdleOutsideOfTheirCellAndBehindTheTreesEnd) {
    const std::vector<Triangle> slabs = test::two_slabs();  // bounds 2 x 1 x 1
    const KdTree free = build(slabs, GetParam(), {}).tree;
    ASSERT_EQ(free.nodes.size(), 1u) << "two triangles are a leaf";
    for (const HandSplit& idle : {HandSplit{"", 0, 2.0f}, {"", 0, 0.0f}, {"", 1, -1.0f}, {"a", 0, 1.0f}}) {
        const Built built = build(slabs, GetParam(), {idle});
        EXPECT_EQ(built.report.idle_hand_splits, 1) << idle.path << idle.position;
        EXPECT_EQ(built.tree, free);
    }
    const Built limited = build(slabs, GetParam(), {{"", 0, 1.0f}}, {.reference_cap = 1.0f});
    EXPECT_EQ(limited.report.idle_hand_splits, 0) << "one reference on either side";
    const Built cut = build(slabs, GetParam(), {{"", 0, 0.25f}}, {.reference_cap = 1.0f});
    EXPECT_EQ(cut.report.idle_hand_splits, 1) << "a limit refuses it: three references of two";
    EXPECT_TRUE(cut.report.reference_cap_hit);
}

TEST_P(HandSplits, SplitWhatWouldBeALeaf) {
    const std::vector<Triangle> one{test::slab(0, 1)};
    const Built built = build(one, GetParam(), {{"", 0, 0.5f}, {"b", 1, 0.25f}});
    EXPECT_EQ(built.report.idle_hand_splits, 0);
    EXPECT_EQ(built.tree.nodes.size(), 5u);
    EXPECT_EQ(build({}, GetParam(), {{"", 0, 0.5f}}).report.idle_hand_splits, 1) << "nothing to split";
}

TEST_P(HandSplits, AnIdleOneDoesNotLetEmptySpaceBeCutOffALeaf) {
    std::vector<Triangle> slabs = test::two_slabs();
    slabs.push_back(test::slab(1.75f, 2.0f));
    // Below x = 1 there is one triangle, and half of the cell is empty.
    const Built built = build(slabs, GetParam(), {{"", 0, 1.0f}, {"b", 0, 5.0f}}, {.empty_cut = 0.25f});
    EXPECT_TRUE(built.tree.nodes[1].is_leaf());
    EXPECT_EQ(built.report.idle_hand_splits, 1);
}

TEST_P(HandSplits, TrianglesInThePlaneStandBelow) {
    const std::vector<Triangle> slabs{test::slab(0, 1), test::slab(1, 1), test::slab(1, 2)};
    const KdTree tree = build(slabs, GetParam(), {{"", 0, 1.0f}}).tree;
    ASSERT_EQ(tree.nodes.size(), 3u);
    EXPECT_EQ(tree.nodes[1].count, 2);
    EXPECT_EQ(tree.nodes[2].count, 1);
}

TEST(HandSplit, BadOnesAreRefused) {
    const auto refusal = [](std::vector<HandSplit> by_hand) {
        return test::refusal([&] { (void)build_tree(test::two_slabs(), {.by_hand = std::move(by_hand)}); });
    };
    EXPECT_EQ(refusal({{"bx", 0, 1}}),
              "plane by hand at 'bx': a path is made of b (the child below) and a (the child above)");
    EXPECT_EQ(refusal({{std::string(64, 'a'), 0, 1}}),
              "plane by hand at '" + std::string(64, 'a') + "': no tree is 65 levels deep");
    EXPECT_EQ(refusal({{"", 3, 1}}), "plane by hand at '': axis 3 is none of 0, 1, 2");
    EXPECT_EQ(refusal({{"a", 0, std::numeric_limits<float>::infinity()}}),
              "plane by hand at 'a': its position is not finite");
    EXPECT_EQ(refusal({{"a", 0, 1}, {"b", 0, 1}, {"a", 1, 2}}),
              "plane by hand at 'a': there is another for the same node");
}

TEST(HandSplit, PathsLeadToNodesAndBack) {
    const KdTree tree = build_tree(test::stress_sphere(12, 6), {});
    for (int node = 0; node < int(tree.nodes.size()); ++node) EXPECT_EQ(node_at(tree, node_path(tree, node)), node);
    EXPECT_EQ(node_at(tree, std::string(60, 'b')), std::nullopt);
    EXPECT_EQ(node_at(tree, "x"), std::nullopt);
}

}  // namespace
}  // namespace kd
