// The two encodings of nodes: exact layout, exact round trip, and refusal beyond what they count.

#include "renderer/kdtree/encode.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "renderer/kdtree/build.h"
#include "tests/core/tree_samples.h"
#include "tests/support/refusal.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::refusal;

TEST(Encode, TexelsOfTwoLeaves) {
    const std::vector<Vec4> expected{{0, 0.5f, 2, -1}, {3, 1, 0, 0}, {3, 1, 1, 0}};
    EXPECT_EQ(encode_float4(test::two_slab_tree()), expected);
}

TEST(Encode, RoundTripIsExact) {
    const std::vector<Triangle> soup = test::random_soup(3000, 0.05f, 5);
    const KdTree tree = build_tree(soup, {});
    EXPECT_EQ(decode_float4(encode_float4(tree), tree.references, tree.bounds), tree);
}

TEST(Encode, TheLargestExactNumberPasses) {
    KdTree tree;
    tree.nodes[0] = test::leaf(1 << 24, 1 << 24, -1);
    EXPECT_EQ(decode_float4(encode_float4(tree), {}, {}), tree);
    tree.nodes[0] = test::leaf((1 << 24) - 1, 0, 1 << 24);
    EXPECT_EQ(decode_float4(encode_float4(tree), {}, {}), tree);
}

TEST(Encode, BoxesThatBacktrackingNeedsAreNotInTheTexels) {
    // Where kd-backtrack leaves a cell at y = 3, it looks for the first node above whose box holds that place.
    const KdTree low = test::empty_cells_tree();
    KdTree high = low;
    high.bounds.upper.y = 4;
    EXPECT_EQ(encode_float4(low), encode_float4(high)) << "parents and all";
    const std::vector<Aabb> of_low = node_boxes(low), of_high = node_boxes(high);
    const int upper_leaf = 3, its_parent = low.nodes[upper_leaf].parent;
    ASSERT_EQ(its_parent, 1);
    EXPECT_LT(of_low[std::size_t(its_parent)].upper.y, 3) << "on to the parent's parent";
    EXPECT_GT(of_high[std::size_t(its_parent)].upper.y, 3) << "down again from the parent";
}

TEST(Encode, OneMoreIsRefusedWithItsNumber) {
    EXPECT_EQ(float((1 << 24) + 1), float(1 << 24)) << "a float has no such number";
    KdTree tree;
    const auto encode = [&] { (void)encode_float4(tree); };
    for (const auto& [node, what] :
         {std::pair{test::leaf((1 << 24) + 1, 0, -1), "link"}, std::pair{test::leaf(0, (1 << 24) + 1, -1), "count"},
          std::pair{test::leaf(0, 0, (1 << 24) + 1), "parent"},
          std::pair{test::interior(0, 1.0f, (1 << 24) + 1, -1), "link"}}) {
        tree.nodes[0] = node;
        const std::string message = refusal(encode);
        EXPECT_NE(message.find(std::string("node 0: ") + what + " 16777217 "), std::string::npos) << message;
        EXPECT_NE(message.find("16777216"), std::string::npos) << message;
    }
}

TEST(Decode, RefusesTexelsThatAreNoTree) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto decode = [](Vec4 texel) { return refusal([&] { (void)decode_float4({texel}, {}, {}); }); };
    EXPECT_NE(decode({7, 0, 0, -1}).find("texel 0: flag 7"), std::string::npos);
    EXPECT_NE(decode({-1, 0, 0, -1}).find("flag -1"), std::string::npos) << "the paper's invalid node";
    EXPECT_NE(decode({nan, 0, 0, -1}).find("flag nan"), std::string::npos);
    EXPECT_NE(decode({3, 0.5f, 0, -1}).find("count 0.5"), std::string::npos);
    EXPECT_NE(decode({3, 0, 1e30f, -1}).find("link 1e+30"), std::string::npos);
    EXPECT_NE(decode({3, 0, 0, nan}).find("parent nan"), std::string::npos);
    EXPECT_NE(refusal([] { (void)decode_float4({}, {}, {}); }).find("empty"), std::string::npos);
}

TEST(Decode, KeepsAnySplitForValidationToJudge) {
    const KdTree tree = decode_float4({{0, -1e30f, 2, -1}, {3, 0, 0, 0}, {3, 0, 0, 0}}, {}, {});
    EXPECT_EQ(tree.nodes[0].split, -1e30f);
}

using Words = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Words words(const std::vector<PackedNode>& nodes) {
    Words found;
    for (const PackedNode& node : nodes) found.emplace_back(node.value, node.kind_and_link);
    return found;
}

TEST(EncodePacked, WordsOfTwoLeaves) {
    // 0.5f is 0x3f000000; the root's axis is 0 and its upper child 2; the leaves' lists begin at 0 and 1.
    const Words expected{{0x3f000000, 2 << 2 | 0}, {1, 0 << 2 | 3}, {1, 1 << 2 | 3}};
    EXPECT_EQ(words(encode_packed(test::two_slab_tree())), expected);
}

TEST(EncodePacked, RoundTripFindsTheParentsAgain) {
    const std::vector<Triangle> soup = test::random_soup(3000, 0.05f, 5);
    for (const Builder& builder : builders()) {
        BuildConfig build;
        build.builder = builder.name;
        const KdTree tree = build_tree(soup, build);
        EXPECT_EQ(decode_packed(encode_packed(tree), tree.references, tree.bounds), tree) << builder.name;
    }
    EXPECT_EQ(decode_packed(encode_packed(KdTree{}), {}, {}), KdTree{});
}

TEST(EncodePacked, NumbersBeyondWhatFloatsHoldPass) {
    KdTree tree;
    const auto last = std::int32_t(packed_link_limit);
    tree.nodes[0] = test::leaf(last, std::numeric_limits<std::int32_t>::max(), -1);
    EXPECT_EQ(decode_packed(encode_packed(tree), {}, {}), tree);
    tree.nodes[0] = test::interior(2, -1e30f, last, -1);
    EXPECT_EQ(words(encode_packed(tree))[0].second, 0xffff'fffeu) << "all bits of the link, and axis 2";
}

TEST(EncodePacked, OneMoreIsRefusedWithItsNumber) {
    KdTree tree;
    const auto beyond = std::int32_t(packed_link_limit + 1);
    for (const TreeNode& node : {test::leaf(beyond, 0, -1), test::interior(0, 1.0f, beyond, -1)}) {
        tree.nodes[0] = node;
        const std::string message = refusal([&] { (void)encode_packed(tree); });
        EXPECT_NE(message.find("node 0: link 1073741824 "), std::string::npos) << message;
        EXPECT_NE(message.find("1073741823"), std::string::npos) << message;
    }
    tree.nodes[0] = test::leaf(-1, 0, -1);
    EXPECT_NE(refusal([&] { (void)encode_packed(tree); }).find("link -1"), std::string::npos);
}

TEST(DecodePacked, RefusesNodesThatAreNoTree) {
    const auto decode = [](const std::vector<TreeNode>& nodes) {
        KdTree tree;
        tree.nodes = nodes;
        return refusal([&] { (void)decode_packed(encode_packed(tree), {}, {}); });
    };
    const TreeNode leaf = test::leaf(0, 0, 0);
    EXPECT_NE(refusal([] { (void)decode_packed({}, {}, {}); }).find("at least one"), std::string::npos);
    EXPECT_NE(decode({test::interior(0, 1, 2, -1)}).find("child 1"), std::string::npos) << "the child below is missing";
    EXPECT_NE(decode({test::interior(0, 1, 3, -1), leaf, leaf}).find("node 0: child 3"), std::string::npos);
    EXPECT_NE(decode({test::interior(0, 1, 0, -1), leaf, leaf}).find("child 0"), std::string::npos) << "a circle";
    EXPECT_EQ(decode({test::interior(0, 1, 2, -1), leaf, leaf}), "accepted");
}

}  // namespace
}  // namespace kd
