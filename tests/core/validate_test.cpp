// The validator finds each kind of damage, tells where, and survives any input.

#include "renderer/kdtree/validate.h"

#include <gtest/gtest.h>
#ifdef KD_WITH_RAPIDCHECK
#include <rapidcheck/gtest.h>
#endif

#include <algorithm>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/coverage.h"
#include "tests/core/tree_samples.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Damage {
    const char* name;
    void (*plant)(KdTree&);  // into two_slab_tree()
    int node;
    const char* message;  // part of it

    friend void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }
};

const Damage damages[] = {
    {"NoNodes", [](KdTree& t) { t.nodes.clear(); }, -1, "no node"},
    {"Flag", [](KdTree& t) { t.nodes[1].flag = 9; }, 1, "flag 9"},
    {"NegativeFlag", [](KdTree& t) { t.nodes[1].flag = -1; }, 1, "flag -1"},
    {"RootParent", [](KdTree& t) { t.nodes[0].parent = 0; }, 0, "parent link is 0 instead of -1"},
    {"Parent", [](KdTree& t) { t.nodes[2].parent = 1; }, 2, "parent link is 1 instead of 0"},
    {"LinkBeyondEnd", [](KdTree& t) { t.nodes[0].link = 3; }, 0, "child above is 3"},
    {"LinkNegative", [](KdTree& t) { t.nodes[0].link = -7; }, 0, "child above is -7"},
    {"LinkToItself", [](KdTree& t) { t.nodes[0].link = 0; }, 0, "child above is 0"},
    {"BothLinksToOneChild", [](KdTree& t) { t.nodes[0].link = 1; }, 0, "child above is 1"},
    {"SplitNaN", [](KdTree& t) { t.nodes[0].split = std::numeric_limits<float>::quiet_NaN(); }, 0, "split at nan"},
    {"SplitInfinite", [](KdTree& t) { t.nodes[0].split = infinity; }, 0, "split at inf"},
    {"SplitOutside", [](KdTree& t) { t.nodes[0].split = 2.5f; }, 0, "split at 2.5"},
    {"SplitOnLowerFace", [](KdTree& t) { t.nodes[0].split = 0.0f; }, 0, "split at 0"},
    {"SplitOnUpperFace", [](KdTree& t) { t.nodes[0].split = 2.0f; }, 0, "split at 2"},
    {"SplitOfFlatAxis", [](KdTree& t) { t.bounds.upper.x = 0.0f; }, 0, "not strictly inside"},
    {"BoundsTooSmall", [](KdTree& t) { t.bounds.upper.y = 0.5f; }, -1, "triangle 0 reaches beyond"},
    {"BoundsEmpty", [](KdTree& t) { t.bounds = Aabb{}; }, -1, "triangle 0 reaches beyond"},
    {"BoundsNaN", [](KdTree& t) { t.bounds.lower.z = std::numeric_limits<float>::quiet_NaN(); }, -1, "beyond"},
    {"CountNegative", [](KdTree& t) { t.nodes[1].count = -1; }, 1, "list of -1"},
    {"CountTooLarge", [](KdTree& t) { t.nodes[2].count = 2; }, 2, "outside the 2 references"},
    {"CountHuge", [](KdTree& t) { t.nodes[2].count = std::numeric_limits<int>::max(); }, 2, "outside the 2"},
    {"LeafLinkNegative", [](KdTree& t) { t.nodes[1].link = -1; }, 1, "from -1"},
    {"ListsShareAnEntry", [](KdTree& t) { t.nodes[2].link = 0; }, 2, "shares reference 0"},
    {"EntryLeftOver", [](KdTree& t) { t.references.push_back(1); }, -1, "reference 2 belongs to no leaf"},
    {"UnknownTriangle", [](KdTree& t) { t.references[0] = 2; }, 1, "triangle 2 of 2"},
    {"NegativeTriangle", [](KdTree& t) { t.references[0] = -1; }, 1, "triangle -1 of 2"},
    {"TriangleTwice",
     [](KdTree& t) {
         t.references = {0, 1, 1}, t.nodes[2].count = 2;
     },
     2, "triangle 1 twice"},
    {"TriangleElsewhere",
     [](KdTree& t) {
         t.references = {0, 1, 1}, t.nodes[1].count = 2, t.nodes[2].link = 2;
     },
     1, "triangle 1, which does not touch"},
    {"TriangleNowhere", [](KdTree& t) { t.references = {0}, t.nodes[2].count = 0; }, -1,
     "triangle 1 stands in no leaf"},
    {"TriangleMissedInOneCell", [](KdTree& t) { t.nodes[0].split = 0.25f; }, 2, "does not name triangle 0"},
    {"CornerMissed", [](KdTree& t) { t.nodes[0].split = 0.25f; }, -1, "triangle 0 is named by no leaf at its corner 1"},
    {"NodeUnreached", [](KdTree& t) { t.nodes.push_back(test::leaf(2, 0, 0)); }, 3, "cannot be reached"},
    {"LastNodeInterior", [](KdTree& t) { t.nodes[2] = test::interior(0, 1.0f, 1, 0); }, 2, "child below is missing"},
    {"EndlessLoop", [](KdTree& t) { t.nodes[2] = test::interior(0, 1.0f, 0, 0); }, 2, "child above is 0"},
};

class ValidateDamage : public testing::TestWithParam<Damage> {};

TEST_P(ValidateDamage, IsFound) {
    KdTree tree = test::two_slab_tree();
    GetParam().plant(tree);
    const std::vector<Violation> found = validate(tree, test::two_slabs());
    const bool named = std::any_of(found.begin(), found.end(), [](const Violation& v) {
        return v.node == GetParam().node && v.message.find(GetParam().message) != std::string::npos;
    });
    std::string all;
    for (const Violation& v : found) all += std::to_string(v.node) + ": " + v.message + "\n";
    EXPECT_TRUE(named) << "found: " << all;
}

INSTANTIATE_TEST_SUITE_P(Planted, ValidateDamage, testing::ValuesIn(damages),
                         [](const testing::TestParamInfo<Damage>& test) { return test.param.name; });

TEST(Validate, SoundTreesPass) {
    EXPECT_TRUE(validate(test::two_slab_tree(), test::two_slabs()).empty());
    EXPECT_TRUE(validate(test::empty_cells_tree(), {}).empty());
    EXPECT_TRUE(validate(KdTree{}, {}).empty());
}

TEST(Validate, FindsChildrenOutOfDepthFirstOrder) {
    // The below child's subtree and the above child trade places in memory; each link alone is in range.
    KdTree tree = test::empty_cells_tree();
    tree.nodes = {test::interior(0, 1.0f, 2, -1), test::interior(1, 0.5f, 4, 0), test::leaf(0, 0, 0),
                  test::leaf(0, 0, 1), test::leaf(0, 0, 1)};
    const std::vector<Violation> found = validate(tree, {});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].node, 2) << "node 2 is both the child below node 1 and the child above the root";
}

TEST(Validate, FindsGapsInDepthFirstOrder) {
    KdTree tree;
    tree.bounds = {Vec3(0.0f), Vec3(1.0f)};
    tree.nodes = {test::interior(0, 0.5f, 3, -1), test::leaf(0, 0, 0), test::leaf(0, 0, 0), test::leaf(0, 0, 0)};
    const std::vector<Violation> found = validate(tree, {});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].message, "link to the child above is 3, depth-first order asks for 2");
    EXPECT_EQ(found[1].node, 2);
}

TEST(Validate, FindsATreeTooDeep) {
    KdTree tree;
    tree.bounds = {Vec3(0.0f), Vec3(1.0f)};
    tree.nodes.clear();
    float split = 0.5f;
    for (int depth = 0; depth <= max_tree_depth; ++depth, split *= 0.5f) {
        // Below: the next cut. Above, at the mirrored place at the end: a leaf.
        tree.nodes.push_back(test::interior(0, split, 2 * (max_tree_depth + 1) - depth, depth - 1));
    }
    tree.nodes.push_back(test::leaf(0, 0, max_tree_depth));
    for (int depth = max_tree_depth; depth >= 0; --depth) tree.nodes.push_back(test::leaf(0, 0, depth));
    const std::vector<Violation> found = validate(tree, {});
    ASSERT_EQ(found.size(), 2u);
    for (const Violation& v : found) EXPECT_EQ(v.message, "stands at depth 65, beyond 64");
}

TEST(Validate, StopsAtTheLimit) {
    KdTree tree = test::two_slab_tree();
    tree.references.resize(100, 0);
    EXPECT_EQ(validate(tree, test::two_slabs(), 5).size(), 5u);
    EXPECT_EQ(validate(tree, test::two_slabs(), 0).size(), 0u);
}

TEST(Validate, FindsOneReferenceTakenAway) {
    const std::vector<Triangle> soup = test::random_soup(40, 0.3f, 7);
    const KdTree tree = build_tree(soup, BuildConfig{.intersection_cost = 10.0f, .trim_leaves = false});
    ASSERT_TRUE(validate(tree, soup).empty());
    int found = 0, tried = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (!tree.nodes[i].is_leaf() || tree.nodes[i].count == 0) continue;
        // Drop the leaf's first triangle and close the gap.
        KdTree damaged = tree;
        damaged.references.erase(damaged.references.begin() + damaged.nodes[i].link);
        --damaged.nodes[i].count;
        for (TreeNode& node : damaged.nodes) node.link -= node.is_leaf() && node.link > tree.nodes[i].link;
        const Triangle& lost = soup[std::size_t(tree.references[std::size_t(tree.nodes[i].link)])];
        ++tried;
        if (surface_enters(lost, node_boxes(tree)[i])) {
            ++found;
            EXPECT_FALSE(validate(damaged, soup).empty()) << "leaf " << i;
        } else {
            EXPECT_TRUE(validate(damaged, soup).empty())
                << "leaf " << i << ": only the triangle's box touches the cell";
        }
    }
    EXPECT_GT(found, tried / 4);
    EXPECT_LT(found, tried);
}

TEST(SurfaceEnters, SeparatesBoxFromSurface) {
    const Aabb unit{Vec3(0.0f), Vec3(1.0f)};
    const auto enters = [&](Vec3 a, Vec3 b, Vec3 c) { return surface_enters({{a, b, c}}, unit); };
    EXPECT_TRUE(enters({0.2f, 0.2f, 0.2f}, {0.3f, 0.2f, 0.2f}, {0.2f, 0.3f, 0.2f})) << "inside";
    EXPECT_TRUE(enters({-9, -9, 0.5f}, {9, -9, 0.5f}, {0, 20, 0.5f})) << "cuts across";
    EXPECT_FALSE(enters({-1, 0, 0}, {-1, 1, 0}, {0, 0, 1})) << "touches a face from outside";
    EXPECT_FALSE(enters({1, 0, 0}, {1, 1, 0}, {1, 0, 1})) << "lies in a face";
    EXPECT_FALSE(enters({2.5f, 0, 0.5f}, {0, 2.5f, 0.5f}, {2.5f, 2.5f, 0.5f})) << "boxes overlap, an edge keeps clear";
    EXPECT_FALSE(enters({3.1f, 0, 0}, {0, 3.1f, 0}, {0, 0, 3.1f})) << "boxes overlap, the plane keeps clear";
    EXPECT_TRUE(enters({2.9f, 0, 0}, {0, 2.9f, 0}, {0, 0, 2.9f})) << "the plane cuts off a corner";
    EXPECT_TRUE(
        surface_enters({{Vec3(0.2f, 0.2f, 1), Vec3(0.8f, 0.2f, 1), Vec3(0.2f, 0.8f, 1)}}, {{0, 0, 1}, {1, 1, 1}}))
        << "in a flat box";
}

#ifdef KD_WITH_RAPIDCHECK
RC_GTEST_PROP(Validate, SurvivesGarbage,
              (std::vector<std::array<int, 4>> words, std::vector<std::int32_t> references)) {
    KdTree tree;
    tree.bounds = {Vec3(0.0f), Vec3(8.0f)};
    tree.nodes.clear();
    for (const auto& [flag, value, link, parent] : words) {
        TreeNode node = test::leaf(link, value, parent);
        if (flag % 2 == 0) node = test::interior(std::abs(flag / 2 % 4), float(value), link, parent);
        tree.nodes.push_back(node);
    }
    tree.references = references;
    const std::vector<Triangle> triangles = test::two_slabs();
    RC_ASSERT(!validate(tree, triangles, 1000).empty() || words.size() == 1);
    RC_ASSERT(validate(tree, triangles, 3).size() <= 3u);
}
#endif

}  // namespace
}  // namespace kd
