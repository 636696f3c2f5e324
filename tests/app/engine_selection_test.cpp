// The engine about nodes: what is selected, what its planes cost, what planes by hand change, how the tree is shown.
#include <algorithm>
#include <gtest/gtest.h>

#include "tests/app/engine_run.h"

namespace kd {
namespace {

Session with_plane(Session session, const HandSplit& plane) {
    session.build.by_hand = {plane};
    return session;
}

/// Inside of the root's cell of small_session()'s scene.
HandSplit plane_in(const EngineState& state, float share) {
    const Aabb& bounds = state.world->tree.bounds;
    return {"", 0, bounds.lower.x + share * bounds.extent().x};
}

TEST(EngineSelection, ANodeHasItsCellAndItsPlaceInThePicture) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.select_node("", false);
    ASSERT_TRUE(engine.state().selected);
    EXPECT_EQ(engine.state().selected->cell, engine.state().world->tree.bounds);
    EXPECT_EQ(engine.state().selected->share, 1);
    EXPECT_FALSE(engine.state().selected->outline.empty());
    engine.select_node("b", false);
    ASSERT_TRUE(engine.state().selected);
    EXPECT_EQ(engine.state().selected->node, 1);
    EXPECT_LT(engine.state().selected->share, 1);
    engine.select_node(std::string(60, 'b'), false);
    EXPECT_FALSE(engine.state().selected) << "the tree ends above it";
    engine.select_node(std::nullopt, false);
    EXPECT_FALSE(engine.state().selected);
}

TEST(EngineSelection, ThePinnedPixelTellsLeafAndTriangle) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.set_probes({}, PixelPosition{32, 24});
    const EngineState& state = engine.state();
    ASSERT_TRUE(state.pinned && state.hit);
    EXPECT_EQ(state.hit->triangle, state.pinned->primary().hit.triangle);
    const std::vector<int>& leaves = state.hit->leaves;
    EXPECT_TRUE(std::ranges::binary_search(leaves, state.hit->leaf)) << "the leaf of the hit lists the triangle";
    std::ptrdiff_t entries = std::ranges::count(state.world->tree.references, state.hit->triangle);
    EXPECT_EQ(std::ptrdiff_t(leaves.size()), entries) << "a leaf lists a triangle once";
    engine.set_probes({}, std::nullopt);
    EXPECT_FALSE(state.hit);
}

TEST(EngineSelection, ATriangleClickedOnComesBeforePixels) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    const int other = int(state.world->scene().triangles.size()) - 1;
    engine.select_triangle(other);
    ASSERT_TRUE(state.hit);
    EXPECT_EQ(state.hit->triangle, other);
    EXPECT_FALSE(state.hit->has_ray);
    EXPECT_EQ(state.hit->leaves, leaves_with(state.world->tree, other)) << "as if a ray had hit it";
    engine.select_triangle(other + 1);
    EXPECT_FALSE(state.hit) << "the scene has none such";
    engine.select_triangle(std::nullopt);
    engine.set_probes(PixelPosition{32, 24}, std::nullopt);
    EXPECT_FALSE(state.hit) << "nobody looks at the tree";
    TreeViewWish wish;
    wish.columns = 100;
    engine.show_tree(wish);
    engine.set_probes(PixelPosition{32, 23}, std::nullopt);
    ASSERT_TRUE(state.hit && state.hovered) << "of the pixel under the mouse";
    EXPECT_EQ(state.hit->triangle, state.hovered->primary().hit.triangle);
    EXPECT_TRUE(state.hit->has_ray);
}

TEST(EngineSelection, TrianglesOfANodeAreThoseOfItsLeaves) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const KdTree& tree = engine.state().world->tree;
    engine.select_node("a", false);
    ASSERT_TRUE(engine.state().selected);
    const std::vector<int>& triangles = *engine.state().selected->triangles;
    const int count = int(engine.state().world->scene().triangles.size());
    for (int triangle = 0; triangle < count; ++triangle) {
        const std::vector<int> leaves = leaves_with(tree, triangle);
        const bool below =
            std::ranges::any_of(leaves, [&](int leaf) { return node_path(tree, leaf).starts_with("a"); });
        EXPECT_EQ(std::ranges::binary_search(triangles, triangle), below) << triangle;
    }
}

TEST(EngineSelection, CostsComeForTheNodeThatIsLookedAt) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.select_node("a", false);
    engine.poll();
    EXPECT_FALSE(engine.state().cell.active) << "nobody looks";
    engine.select_node("a", true);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.cell.costs && !s.cell.active; }));
    EXPECT_EQ(engine.state().cell.path, "a");
    EXPECT_EQ(engine.state().cell.costs->node, engine.state().selected->node);
    engine.select_node("b", true);
    EXPECT_TRUE(wait_until(engine, [](const EngineState& s) { return s.cell.path == "b"; }));
}

TEST(EngineSelection, PlanesByHandAreComparedWithTheSamePictureWithoutThem) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    EXPECT_FALSE(state.plane_effect.planes);
    const Session session = state.session;
    const HandSplit plane = plane_in(state, 0.9f);
    engine.set_session(with_plane(session, plane));
    ASSERT_TRUE(settle(engine));
    engine.poll();
    EXPECT_TRUE(state.plane_effect.planes);
    ASSERT_TRUE(state.plane_effect.now && state.plane_effect.without);
    const auto interior = [](const FrameWalks& walks) {
        return walks.totals[0].interior_first + walks.totals[0].interior_again;
    };
    EXPECT_EQ(state.plane_effect.now->totals[0].rays, 64u * 48u);
    EXPECT_NE(interior(*state.plane_effect.now), interior(*state.plane_effect.without));
    const FrameWalks without = *state.plane_effect.without;

    // Another camera, traversal or constant: nothing to compare with yet.
    Session other = with_plane(session, plane);
    other.trace.traversal = Traversal::restart;
    engine.set_session(other);
    ASSERT_TRUE(settle(engine));
    engine.poll();
    EXPECT_FALSE(state.plane_effect.without);
    EXPECT_TRUE(state.plane_effect.now);
    other.trace.traversal = Traversal::stack;
    other.camera = state.camera;
    other.camera->eye.x += 0.1f;
    engine.set_session(other);
    ASSERT_TRUE(settle(engine));
    engine.poll();
    EXPECT_FALSE(state.plane_effect.without);
    other.camera.reset();
    other.build.leaf_size = 5;
    engine.set_session(other);
    ASSERT_TRUE(settle(engine));
    engine.poll();
    EXPECT_FALSE(state.plane_effect.without);

    // Another map of the same walks: the same comparison.
    other = with_plane(session, plane);
    other.view.map.map = "triangles";
    engine.set_session(other);
    ASSERT_TRUE(settle(engine));
    engine.poll();
    ASSERT_TRUE(state.plane_effect.without);
    EXPECT_EQ(state.plane_effect.without->totals, without.totals);
}

TEST(EngineSelection, TreesFollowWishesThatComeFasterThanTheyAreBuilt) {
    Engine engine(small_session("ball:9000"), quiet());
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    const Session session = state.session;
    int trees = 0;
    auto last = state.world;
    // A wish in every round, until three trees came in between: were each build ended by the next wish, none would.
    const auto end = std::chrono::steady_clock::now() + test::patience();
    for (int i = 0; trees < 3 && std::chrono::steady_clock::now() < end; ++i) {
        engine.set_session(with_plane(session, plane_in(state, 0.3f + 1e-4f * float(i % 4000))));
        engine.poll();
        if (state.world != last) ++trees;
        last = state.world;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_GE(trees, 3);
    const HandSplit wanted = plane_in(state, 0.8f);
    engine.set_session(with_plane(session, wanted));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(state.world->tree.nodes[0].flag, wanted.axis);
    EXPECT_EQ(state.world->tree.nodes[0].split, wanted.position) << "the newest wish wins";
}

TEST(EngineSelection, TheTreeIsLaidOutWhereSomeoneLooks) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.poll();
    EXPECT_FALSE(engine.state().tree_view.view);
    TreeViewWish wish;
    wish.columns = 200;
    engine.show_tree(wish);
    const auto shows = [&](const EngineState& s) { return s.tree_view.view && s.tree_view.view->of == wish; };
    ASSERT_TRUE(wait_until(engine, shows));
    const TreeView& view = *engine.state().tree_view.view;
    const KdTree& tree = engine.state().world->tree;
    EXPECT_EQ(view.icicle.front().node, 0);
    EXPECT_FALSE(view.slice.empty());
    EXPECT_EQ(view.colours.of.size(), tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const int shown = view.icicle[std::size_t(view.cell_of[i])].node;
        EXPECT_TRUE(node_path(tree, int(i)).starts_with(node_path(tree, shown)));
    }
    wish.root = "b";
    engine.show_tree(wish);
    ASSERT_TRUE(wait_until(engine, shows));
    EXPECT_EQ(engine.state().tree_view.view->root, 1);
    EXPECT_EQ(engine.state().tree_view.view->cell_of[0], -1) << "outside of what is shown";
}

}  // namespace
}  // namespace kd
