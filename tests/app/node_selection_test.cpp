// One node selected in all views, and planes put by hand: the edits behind SPLITS and NODES, and what their panels do.
#ifdef KD_WITH_WINDOW

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>

#include "app/panels/node_views.h"
#include "app/panels/panel.h"
#include "app/scenes.h"
#include "app/window/cost_chart.h"
#include "app/window/keys.h"
#include "renderer/kdtree/sah.h"
#include "renderer/scene/units.h"
#include "tests/app/ui_run.h"
#include "viz/numbers.h"

namespace kd {
namespace {

std::shared_ptr<World> world_of(const std::string& scene) {
    const auto loaded = std::make_shared<LoadedScene>();
    loaded->name = scene;
    loaded->flat = load_scene(scene, 1);
    auto world = std::make_shared<World>();
    world->loaded = loaded;
    world->tree = build_tree(loaded->flat.triangles, {});
    return world;
}

/// What a tree of one scene makes of edits, without an engine.
class NodeSelectionTest : public testing::Test {
  protected:
    std::shared_ptr<World> world = world_of("scatter:60");
    EngineState state;
    Edit edit;

    NodeSelectionTest() {
        state.world = world;
        state.session.scene = edit.session.scene = "scatter:60";
    }
    [[nodiscard]] const std::vector<HandSplit>& planes() const { return edit.session.build.by_hand; }
    /// As the engine would, of the node that is selected.
    void answer() {
        state.selected.reset();
        if (edit.window.node) state.selected = kd::select_node(world->tree, *edit.window.node, view);
    }
    void reckon_costs() {
        answer();
        auto costs = cell_costs(world->scene().triangles, world->tree, state.selected->node, {});
        state.cell.path = state.selected->path;
        state.cell.world = world;
        for (std::size_t axis = 0; axis < 3; ++axis)
            state.cell.curves[axis] =
                thin(costs.curves[axis], costs.cell.lower[int(axis)], costs.cell.upper[int(axis)]);
        state.cell.costs = std::make_shared<const CellCosts>(std::move(costs));
    }

    PictureView view{pinhole(Camera{}, 64, 48), 64, 48};
};

TEST_F(NodeSelectionTest, APlaneThatIsNotUsedIsNotTheNodes) {
    const HandSplit outside{"", 0, 99.0f};
    world->built_with.by_hand = edit.session.build.by_hand = {outside};
    edits::select_node(state, edit, 0);
    const TreeNode& root = world->tree.nodes[0];
    EXPECT_EQ(edits::shown_plane(state, edit), (HandSplit{"", root.flag, root.split}));
    world->built_with.by_hand.clear();
    EXPECT_EQ(edits::shown_plane(state, edit), outside) << "a tree with it is on its way";
}

TEST_F(NodeSelectionTest, PlanesAreThoseOfTheTreeUntilSomeoneElsePutsThem) {
    EXPECT_FALSE(edits::shown_plane(state, edit)) << "nothing is selected";
    edits::select_node(state, edit, 0);
    const TreeNode& root = world->tree.nodes[0];
    ASSERT_FALSE(root.is_leaf());
    EXPECT_EQ(edits::shown_plane(state, edit), (HandSplit{"", root.flag, root.split}));
    edits::put_plane(edit, {"", 1, 0.25f}, true);
    EXPECT_EQ(edits::shown_plane(state, edit), (HandSplit{"", 1, 0.25f}));
    EXPECT_TRUE(edits::has_plane(edit));
    edits::put_plane(edit, {"", 2, 0.5f}, true);
    EXPECT_EQ(planes().size(), 1u) << "it takes the place of the one before";
    edits::put_plane(edit, {"a", 0, 0.5f}, true);
    EXPECT_EQ(planes().size(), 2u);
    edits::put_plane_back(edit);
    EXPECT_EQ(planes(), (std::vector<HandSplit>{{"a", 0, 0.5f}})) << "the other node keeps its own";
    edits::put_planes_back(edit);
    EXPECT_TRUE(planes().empty());
    EXPECT_EQ(edits::shown_plane(state, edit), (HandSplit{"", root.flag, root.split}));
}

TEST_F(NodeSelectionTest, ADragIsUndoneAsOne) {
    EXPECT_FALSE(edits::can_undo_planes(edit));
    edits::put_plane(edit, {"", 0, 0.1f}, true);
    for (const float x : {0.2f, 0.3f, 0.4f}) edits::put_plane(edit, {"", 0, x}, false);
    edits::put_plane(edit, {"", 0, 0.6f}, true);
    edits::put_plane(edit, {"", 0, 0.7f}, false);
    edits::put_plane(edit, {"", 0, 0.7f}, true);  // a press that moves nothing
    apply_key('Z', 2, state, edit);               // Ctrl
    EXPECT_EQ(planes(), (std::vector<HandSplit>{{"", 0, 0.4f}}));
    edits::undo_planes(edit);
    EXPECT_TRUE(planes().empty());
    EXPECT_FALSE(edits::can_undo_planes(edit));
    edits::undo_planes(edit);
    EXPECT_TRUE(planes().empty());
}

TEST_F(NodeSelectionTest, PlanesGoWithTheirScene) {
    edits::put_plane(edit, {"", 0, 0.1f}, true);
    edits::compare(edit);
    edits::compare(edit);
    EXPECT_EQ(planes().size(), 1u) << "A and B are of one scene";
    edits::compare(edit);
    edits::choose_scene(edit, "scatter:70");
    EXPECT_TRUE(planes().empty());
    EXPECT_FALSE(edits::can_undo_planes(edit));
    edits::compare(edit);
    EXPECT_TRUE(planes().empty()) << "the other configuration's were of the scene before";
}

TEST_F(NodeSelectionTest, PositionsAreKeptStrictlyInsideOfTheCell) {
    const Aabb cell{Vec3(-1, 2, 5), Vec3(1, 4, 5)};
    EXPECT_EQ(edits::inside(cell, 0, 0.25f), 0.25f);
    EXPECT_GT(edits::inside(cell, 0, -7), -1.0f);
    EXPECT_LT(edits::inside(cell, 0, 7), 1.0f);
    EXPECT_GT(edits::inside(cell, 1, 2), 2.0f);
    EXPECT_FALSE(edits::inside(cell, 2, 5)) << "a flat cell has no inside";
}

TEST_F(NodeSelectionTest, ThePinnedPixelSelectsItsLeafOnceItIsRead) {
    edit.hovered = PixelPosition{4, 5};
    edits::pin(edit);
    const auto picture = std::make_shared<Picture>();
    picture->traced.world = world;
    state.picture = picture;
    edits::follow_ray(state, edit);
    EXPECT_FALSE(edit.window.node) << "nobody has read the pixel";
    const int leaf = int(std::ranges::find_if(world->tree.nodes, &TreeNode::is_leaf) - world->tree.nodes.begin());
    state.hit = HitSelection{};
    state.hit->leaf = leaf;
    state.pinned = PixelReading{{4, 5}, 8, {}, {}};
    edits::follow_ray(state, edit);
    EXPECT_FALSE(edit.window.node) << "of a coarse picture";
    state.pinned->scale = 1;
    edits::follow_ray(state, edit);
    EXPECT_EQ(edit.window.node, node_path(world->tree, leaf));
    EXPECT_EQ(edits::selected_node(state, edit), leaf);

    edits::select_node(state, edit, 0);
    edits::follow_ray(state, edit);
    EXPECT_EQ(edit.window.node, "") << "the pixel is asked once";
    edits::step_ray(state, edit, 1);
    state.step = StepReading{};
    state.step->leaf.node = leaf;
    edits::follow_ray(state, edit);
    EXPECT_EQ(edits::selected_node(state, edit), leaf) << "a step along its ray";
    apply_key(256, 0, state, edit);  // Esc
    EXPECT_FALSE(edit.window.node);
    EXPECT_FALSE(edit.window.pinned);
}

TEST_F(NodeSelectionTest, TheWheelGoesStepByStep) {
    EXPECT_EQ(one_step_towards("", "bba"), "b");
    EXPECT_EQ(one_step_towards("b", "bba"), "bb");
    EXPECT_EQ(one_step_towards("bba", "bba"), "bba");
    EXPECT_EQ(one_step_towards("a", "bb"), "bb") << "not beneath: there at once";
}

TEST_F(NodeSelectionTest, EntriesBelowANodeAreThoseOfItsLeaves) {
    const KdTree& tree = world->tree;
    EXPECT_EQ(references_below(tree, 0), std::int64_t(tree.references.size()));
    for (int node = 0; node < int(tree.nodes.size()); ++node) {
        const TreeNode& n = tree.nodes[std::size_t(node)];
        if (n.is_leaf())
            EXPECT_EQ(references_below(tree, node), n.count);
        else
            EXPECT_EQ(references_below(tree, node), references_below(tree, node + 1) + references_below(tree, n.link));
    }
}

TEST_F(NodeSelectionTest, TheNearestCandidateIsTaken) {
    const std::vector<SplitCandidate> curve{{.position = 1}, {.position = 2}, {.position = 4}};
    const auto nearest = [&](float position) { return nearest_candidate(curve, position)->position; };
    EXPECT_EQ(nearest(-5), 1.0f);
    EXPECT_EQ(nearest(1.4f), 1.0f);
    EXPECT_EQ(nearest(1.6f), 2.0f);
    EXPECT_EQ(nearest(3.1f), 4.0f);
    EXPECT_EQ(nearest(9), 4.0f);
    EXPECT_FALSE(nearest_candidate({}, 1));
}

TEST_F(NodeSelectionTest, ThinCurvesKeepTheCheapestPlanes) {
    std::vector<SplitCandidate> curve;
    for (int i = 1; i < 1000; ++i)
        curve.push_back({.position = float(i), .cost = i == 337 ? -1.0 : i == 338 ? 9999.0 : 1000.0 - i});
    EXPECT_EQ(thin(curve, 0, 1000, 2000).points.size(), curve.size()) << "few enough";
    const ThinCurve drawn = thin(curve, 0, 1000, 100);
    EXPECT_LE(drawn.points.size(), 100u);
    const auto cheapest = std::ranges::min_element(drawn.points, {}, &ThinCurve::Point::least);
    EXPECT_EQ(cheapest->position, 337);
    EXPECT_EQ(cheapest->least, -1);
    EXPECT_EQ(cheapest->most, 9999) << "of the same part";
}

TEST_F(NodeSelectionTest, AClickOnATriangleOfTheSliceSelectsIt) {
    TreeView made;
    made.world = world;
    made.cell_of.assign(world->tree.nodes.size(), -1);
    made.of.slice = {2, world->tree.bounds.centre()[2]};
    made.slice = slice_cells(world->tree, made.of.slice, max_tree_depth);
    const Aabb& bounds = world->tree.bounds;
    const float y = bounds.centre()[1];
    made.segments = {{7, {bounds.lower[0], y}, {bounds.upper[0], y}}};  // across the middle of the slice
    state.tree_view.view = std::make_shared<const TreeView>(made);
    edit.window.pinned = PixelPosition{1, 2};
    const auto panel = std::ranges::find(panels(), std::string_view(nodes_panel), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); }, 1000);
    ui.point_at("slice");
    EXPECT_TRUE(ui.tooltip().starts_with("triangle #7")) << ui.tooltip();
    ui.click();
    EXPECT_EQ(edit.window.triangle, 7);
    EXPECT_FALSE(edit.window.pinned) << "one triangle at a time";
    EXPECT_FALSE(edit.window.node);
    const Rectangle slice = ui.place("slice");
    ui.move_to({slice.x + slice.width / 2, slice.y + slice.height / 2 + 10});
    ui.click();
    EXPECT_TRUE(edit.window.node) << "beside it: the leaf";
    EXPECT_EQ(edit.window.triangle, 7);
    edits::release(edit);
    EXPECT_FALSE(edit.window.triangle);
}

TEST_F(NodeSelectionTest, SplitsLeadsThroughTheTree) {
    const auto panel = std::ranges::find(panels(), std::string_view(splits_panel), &Panel::title);
    test::Ui ui(
        [&] {
            answer();
            panel->draw(state, edit);
        },
        1000);
    ui.click_on("root");
    EXPECT_EQ(edit.window.node, "");
    ui.click_on("above");
    EXPECT_EQ(edit.window.node, "a");
    ui.click_on("parent");
    EXPECT_EQ(edit.window.node, "");
    ui.click_on("below");
    EXPECT_EQ(edit.window.node, "b");
}

TEST_F(NodeSelectionTest, TheTooltipOfAChartNamesThePlaneThatAClickTakes) {
    edits::select_node(state, edit, 0);
    reckon_costs();
    const auto panel = std::ranges::find(panels(), std::string_view(splits_panel), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); }, 1000);
    for (const bool shift : {false, true})
        for (int i = 1; i < 40; ++i) {
            ui.move_to({});
            ImGui::GetIO().KeyShift = shift;
            ui.point_at("across y", 0.025f * float(i));
            const std::string told = ui.tooltip();
            ui.click();
            ASSERT_EQ(planes().size(), 1u);
            const float at = to_scene_units(world->scene(), planes()[0].position);
            EXPECT_TRUE(told.starts_with(fmt::format("y at {}", number_text(double(at))))) << told << "\n" << at;
        }
}

TEST_F(NodeSelectionTest, APlaneStandsOnTheCurveAtItsCost) {
    edits::select_node(state, edit, 0);
    reckon_costs();
    const CellCosts& costs = *state.cell.costs;
    ASSERT_TRUE(costs.chosen);
    const int axis = costs.chosen->axis;
    const CostChart chart{.cell = state.cell, .axis = axis, .scale = {}, .plane = {}};
    EXPECT_EQ(cost_at(chart, costs.chosen->position), costs.chosen_cost);
    const std::vector<SplitCandidate>& curve = costs.curves[std::size_t(axis)];
    const SplitCost cost_of(world->built_with, costs.cell, axis);
    // The root's cell holds all triangles whole.
    const auto counted = [&](float position) {
        int below = 0, above = 0;
        for (const Triangle& triangle : world->scene().triangles) {
            below += bounds_of(triangle).lower[axis] < position;
            above += bounds_of(triangle).upper[axis] > position;
        }
        return cost_of(position, below, above);
    };
    for (std::size_t i = 1; i < curve.size(); ++i) {
        EXPECT_EQ(cost_at(chart, curve[i].position), curve[i].cost);
        const float between = std::midpoint(curve[i - 1].position, curve[i].position);
        if (between == curve[i - 1].position || between == curve[i].position) continue;
        // A line is reckoned here, its points there: ten roundings of numbers below 100 are far below 1e-9.
        EXPECT_NEAR(cost_at(chart, between), counted(between), 1e-9) << between;
    }
    const float behind = std::midpoint(curve.back().position, costs.cell.upper[axis]);
    if (behind > curve.back().position) {
        EXPECT_EQ(cost_at(chart, behind), curve.back().cost_after);
    }
}

TEST_F(NodeSelectionTest, AClickInAChartPutsThePlaneThere) {
    edits::select_node(state, edit, 0);
    reckon_costs();
    const auto panel = std::ranges::find(panels(), std::string_view(splits_panel), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); }, 1000);
    const std::vector<SplitCandidate>& curve = state.cell.costs->curves[2];
    ui.click_on("across z", 0.6f);
    ASSERT_EQ(planes().size(), 1u);
    EXPECT_EQ(planes()[0].axis, 2);
    EXPECT_TRUE(std::ranges::any_of(curve, [&](const SplitCandidate& c) { return c.position == planes()[0].position; }))
        << "an end of a triangle";
    ui.click_on("put back");
    EXPECT_TRUE(planes().empty());
    const BuilderChoice& median =
        *std::ranges::find(state.cell.costs->choices, "spatial-median", &BuilderChoice::builder);
    ASSERT_TRUE(median.split);
    ui.click_on("builder spatial-median");
    EXPECT_EQ(planes(), (std::vector<HandSplit>{{"", median.split->axis, median.split->position}}));
    ui.click_on("undo");
    EXPECT_TRUE(planes().empty());
}

TEST_F(NodeSelectionTest, ThePlaneOfTheNodeIsCopiedAsAnOption) {
    edits::select_node(state, edit, world->tree.nodes[0].link);
    edits::put_plane(edit, {"a", 1, 0.1f}, true);
    reckon_costs();
    const auto panel = std::ranges::find(panels(), std::string_view(splits_panel), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); }, 1000);
    ui.click_on("copy --split");
    EXPECT_EQ(ImGui::GetClipboardText(),
              fmt::format("--split a:y:{}", to_scene_units(world->scene(), 0.1f)));  // the shortest text that is exact
}

TEST_F(NodeSelectionTest, EveryPlaneByHandIsNamedAndTheIdleSayWhy) {
    const Aabb& bounds = world->tree.bounds;
    const std::string deep(max_tree_depth - 1, path_below);
    BuildConfig config;
    config.by_hand = {{"", 0, bounds.centre()[0]}, {"a", 0, bounds.lower[0]}, {deep, 1, 0}};
    auto built = std::make_shared<World>(*world);
    built->built_with = config;
    built->tree = build_tree(world->scene().triangles, config, &built->report);
    EXPECT_EQ(built->report.idle_hand_splits, 2);
    state.world = built;
    edit.session.build = config;
    state.plane_effect.planes = true;
    const auto panel = std::ranges::find(panels(), std::string_view(splits_panel), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); }, 1000);
    ui.point_at("planes/root");
    EXPECT_EQ(ui.tooltip().find("Not used"), std::string::npos);
    ui.point_at("planes/a");
    EXPECT_NE(ui.tooltip().find("Not used: it is not inside its cell"), std::string::npos) << ui.tooltip();
    ui.point_at("planes/" + deep);
    EXPECT_NE(ui.tooltip().find("Not used: the tree ends above its node"), std::string::npos) << ui.tooltip();
    ui.click_on("planes/a");
    EXPECT_EQ(edit.window.node, "a");
    edits::put_planes_back(edit);
    edits::undo_planes(edit);
    EXPECT_EQ(planes(), config.by_hand);
}

TEST_F(NodeSelectionTest, PlanesRemovedInTreeComeBackWithUndo) {
    edits::put_plane(edit, {"", 0, 0.1f}, true);
    const auto panel = std::ranges::find(panels(), std::string_view("TREE"), &Panel::title);
    test::Ui ui([&] { panel->draw(state, edit); });
    ui.click_on("more constants");
    ui.click_on("remove 1");
    EXPECT_TRUE(planes().empty());
    EXPECT_TRUE(ui.sees("none")) << "the row stays";
    edits::undo_planes(edit);
    EXPECT_EQ(planes().size(), 1u);
}

}  // namespace
}  // namespace kd

#endif
