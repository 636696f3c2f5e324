// Panels drawn without a window: what they offer for a scene, and what becomes of what is typed into them.
#ifdef KD_WITH_WINDOW

#include "app/panels/panel.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "app/panels/applies.h"
#include "app/scenes.h"
#include "renderer/kdtree/build.h"
#include "tests/app/ui_run.h"

namespace kd {
namespace {

std::shared_ptr<const World> world_of(const std::string& scene, const std::function<void(FlatScene&)>& change = {}) {
    const auto loaded = std::make_shared<LoadedScene>();
    loaded->name = scene;
    loaded->flat = load_scene(scene, 1);
    if (change) change(loaded->flat);
    const auto world = std::make_shared<World>();
    world->loaded = loaded;
    world->tree = build_tree(loaded->flat.triangles, {});
    world->facts = scene_facts(loaded->flat, world->tree);
    return world;
}

/// A panel of a scene, without an engine: nothing answers what is asked for.
class Panels : public testing::Test {
  protected:
    EngineState state;
    Edit edit;

    void show(const std::string& scene, const std::function<void(FlatScene&)>& change = {}) {
        state.world = world_of(scene, change);
        state.session.scene = edit.session.scene = scene;
    }
    std::unique_ptr<test::Ui> draw(std::string_view title, float width = 300) {
        const auto panel = std::ranges::find(panels(), title, &Panel::title);
        return std::make_unique<test::Ui>([this, panel] { panel->draw(state, edit); }, width);
    }
};

TEST_F(Panels, RaysThatTheSceneLacksCannotBeChosen) {
    show("scatter:60");
    const auto ui = draw("VIEW");
    const auto choose = [&](const char* line) {
        ui->click_on("rays");
        ui->click_on(line);
        ui->press(ImGuiKey_Escape);
        return edit.session.view.map.rays;
    };
    EXPECT_EQ(choose("rays/reflection"), Pass::rt_prim);
    EXPECT_EQ(choose("rays/reflection shadow"), Pass::rt_prim);
    EXPECT_EQ(choose("rays/shadow"), Pass::shade_prim);
    edit.session.trace.forced = Feature::reflections;
    EXPECT_EQ(choose("rays/reflection"), Pass::rt_refl) << "put back";
    edit.session.trace.forced = {};
    edit.session.view.map.rays = Pass::rt_prim;
    show("cornell");
    EXPECT_EQ(choose("rays/reflection"), Pass::rt_refl) << "a mirror";
    EXPECT_EQ(choose("rays/reflection shadow"), Pass::shade_refl);
}

TEST_F(Panels, RowsOfPixelAreThoseOfRaysThatThereAre) {
    const auto rows = [&](std::string_view scene) {
        show(std::string(scene));
        const auto ui = draw("PIXEL");
        std::vector<std::string> found;
        for (const std::string_view name : ray_names)
            if (ui->sees(std::string(name))) found.emplace_back(name);
        return found;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(rows("scatter:60"), (Names{"shadow"}));
    EXPECT_EQ(rows("ball:300"), (Names{"shadow", "reflection", "reflection shadow"})) << "its floor mirrors";
    EXPECT_EQ(rows("cornell"), (Names{"shadow", "reflection", "reflection shadow"}));
    edit.session.trace.shadows = false;
    EXPECT_EQ(rows("cornell"), (Names{"reflection"}));
    edit.session.trace.forced = Feature::reflections;
    EXPECT_EQ(rows("scatter:60"), (Names{"reflection"}));
}

TEST_F(Panels, SwitchesOfWhatTheSceneLacksAreGreyedOut) {
    show("scatter:60", [](FlatScene& scene) { scene.lights.clear(); });
    const auto ui = draw("TRACING");
    ui->click_on("bounces", 0.02f);
    ui->click_on("shadows");
    EXPECT_EQ(edit.session.trace.reflection_depth, 1);
    EXPECT_TRUE(edit.session.trace.shadows);
    show("cornell");
    ui->frames(2);
    ui->click_on("bounces", 0.02f);
    ui->click_on("shadows");
    EXPECT_EQ(edit.session.trace.reflection_depth, 0);
    EXPECT_FALSE(edit.session.trace.shadows);
    ui->click_on("bounces", 0.98f);
    ui->click_on("shadows");
    EXPECT_EQ(edit.session.trace.reflection_depth, 8) << "what is off can be switched on again";
    EXPECT_TRUE(edit.session.trace.shadows);
}

TEST_F(Panels, MotionIsPlayedWhereSomethingMoves) {
    show("cornell");
    const auto ui = draw(motion_panel, 900);
    EXPECT_FALSE(ui->sees("play"));
    show("sheet:200");
    ui->frames(2);
    ui->click_on("play");
    EXPECT_TRUE(edit.window.motion.playing);
    EXPECT_TRUE(ui->sees("stop"));
    ui->click_on("time", 0.5f);
    EXPECT_NEAR(edit.session.time, 2, 0.1) << "of 4 s";
    EXPECT_FALSE(edit.window.motion.playing) << "who seeks looks at one pose";
    ui->click_on(">");
    EXPECT_NEAR(edit.session.time, 2, 0.2);
    ui->click_on("rebuild");
    ui->click_on("rebuild/refit");
    EXPECT_TRUE(edit.window.motion.refit);
    ui->click_on("schedule");
    ui->click_on("schedule/on-demand");
    EXPECT_EQ(edit.window.motion.schedule, FrameSchedule::on_demand);
}

TEST_F(Panels, TheChartOfAMotionReadsItsStepsOut) {
    show("sheet:200");
    const auto ui = draw(motion_panel, 1000);
    EXPECT_FALSE(ui->sees("gantt"));
    for (int n = 0; n < 10; ++n) {  // 0.1 s each, traced for the second half of it
        FrameSteps steps;
        const double begin = 0.1 * n;
        steps[FrameStep::update] = {begin, begin + 0.01};
        steps[FrameStep::build] = {begin + 0.01, begin + 0.03};
        steps[FrameStep::upload] = {begin + 0.03, begin + 0.05};
        steps[FrameStep::trace] = {begin + 0.05, begin + 0.1};
        state.motion.recent.frames.push_back(steps);
    }
    state.motion.played = 40;
    ui->frames(2);
    const Rectangle chart = ui->place("gantt");
    // Eight frames, the last of them number 39: the trace of that fills the last sixteenth.
    const float tracing = chart.y + theme::px(60);
    ui->move_to({chart.x + chart.width - 5, tracing});
    EXPECT_EQ(ui->tooltip(), "frame 39: trace 50.00 ms");
    ui->move_to({chart.x + chart.width - 5, chart.y + 5});
    EXPECT_EQ(ui->tooltip(), "") << "nothing was built then";
}

TEST_F(Panels, TexturesAreARowWhereThereAreSome) {
    show("scatter:60");
    const auto ui = draw("SCENE");
    EXPECT_FALSE(ui->sees("textures"));
    edit.session.trace.forced = Feature::textures;
    ui->frames(2);
    EXPECT_TRUE(ui->sees("textures"));
    edit.session.trace.forced = {};
    show("sheet:200");
    ui->frames(2);
    EXPECT_TRUE(ui->sees("textures"));
}

TEST_F(Panels, LabelsEndBeforeTheirControls) {
    show("scatter:60");
    // As wide as the column is at first, with its scroll bar, and dragged narrow.
    for (const float width : {LayoutSizes{}.left, LayoutSizes{}.left - 10, 220.0f}) {
        const auto ui = draw("TREE", width);
        ui->click_on("more constants");
        for (const char* label : {"traversal cost (t_t)", "intersection cost (t_i)", "empty bonus (b_e)", "bonus gate",
                                  "max depth", "bad refines", "reference cap", "trim leaves"}) {
            const Rectangle control = ui->place(label);
            EXPECT_LT(ImGui::GetStyle().WindowPadding.x + ImGui::CalcTextSize(label).x, control.x) << label;
            EXPECT_LE(control.x + control.width, width) << label;
        }
    }
}

TEST_F(Panels, TimeHasDashesForAGpuThatNobodyKnows) {
    show("scatter:60");
    const auto ui = draw("TIME", 1000);
    EXPECT_TRUE(ui->sees("upload"));
    EXPECT_TRUE(ui->sees("compile"));
}

TEST_F(Panels, AReasonStandsBesideWhatIsAbsent) {
    show("scatter:60");
    const TraceConfig trace;
    EXPECT_EQ(why_absent(state, trace, Pass::rt_refl), "no reflective material");
    EXPECT_EQ(why_absent(state, trace, Pass::shade_prim), "");
    EXPECT_EQ(why_absent(state, {.shadows = false}, Pass::shade_prim), "switched off");
    EXPECT_EQ(ray_options(state, trace)[2].missing, "no reflective material");
    EXPECT_EQ(why_no_pass(state, {.shadows = false}, Pass::shade_prim), "") << "it shades all the same";
    state.world = nullptr;
    EXPECT_EQ(why_absent(state, trace, Pass::rt_refl), "") << "nobody knows yet";
}

TEST_F(Panels, WhatIsTypedStaysUntilItIsThere) {
    show("scatter:60");
    const auto ui = draw("SCENE");
    const auto type = [&](const char* text) {
        ui->click_on("open");
        ui->press(ImGuiKey_End);
        ui->type(text);
        ui->press(ImGuiKey_Enter);
    };
    type("scater:70");
    EXPECT_EQ(edit.session.scene, "scater:70");
    state.refused = RefusedScene{"scater:70", "scater:70: there is no such scene"};
    edit.session = state.session;
    ui->frames(2);
    edits::settle_typed(state, edit);
    EXPECT_EQ(edit.window.scene_text, "scater:70");
    EXPECT_TRUE(ui->sees("refused"));
    EXPECT_FALSE(ui->sees("tooltip")) << "it would hide the reason";

    // Mended: another end.
    ui->click_on("open");
    ui->press(ImGuiKey_Home);
    for (int i = 0; i < 3; ++i) ui->press(ImGuiKey_RightArrow);
    ui->type("t");
    ui->press(ImGuiKey_Enter);
    EXPECT_EQ(edit.session.scene, "scatter:70");
    state.refused.reset();
    ui->frames(2);
    EXPECT_FALSE(ui->sees("refused"));
    EXPECT_EQ(edit.window.scene_text, "scatter:70") << "still loading";
    show("scatter:70");
    edits::settle_typed(state, edit);
    ui->frames(2);
    EXPECT_EQ(edit.window.scene_text, "");
    type("scatter:70");
    edits::settle_typed(state, edit);
    EXPECT_EQ(edit.window.scene_text, "") << "it is there already";
}

TEST_F(Panels, ARefusalOfAnotherWishIsNotThatOfTheField) {
    show("scatter:60");
    state.refused = RefusedScene{"dropped.glb", "dropped.glb: cannot be opened"};
    EXPECT_EQ(edits::why_refused(state, edit), "");
    EXPECT_FALSE(draw("SCENE")->sees("refused"));
}

TEST_F(Panels, TheWayBackFromACaseIsOfferedWhereThereIsOne) {
    show("scatter:60");
    const auto ui = draw("STABILITY", 1280);
    ASSERT_TRUE(ui->sees("show scene"));
    EXPECT_FALSE(ui->sees_any("back to")) << "no case was shown yet";
    edit.session.camera = Camera{};
    ui->click_on("show scene");
    EXPECT_EQ(edit.session.scene, "stress:T16");
    EXPECT_FALSE(edit.session.camera);
    ASSERT_TRUE(ui->sees("back to scatter:60"));
    ui->click_on("back to scatter:60");
    EXPECT_EQ(edit.session.scene, "scatter:60");
    EXPECT_EQ(edit.session.camera, Camera{});
    EXPECT_FALSE(ui->sees_any("back to"));
    edit.session.scene = "/home/someone/models/lamp.glb";
    edits::show_stress(edit, "stress:T16");
    ui->frames(2);
    EXPECT_TRUE(ui->sees("back to lamp.glb")) << "not a path wider than the panel";
}

TEST_F(Panels, ACaseThatTheWindowWasOpenedWithHasNoWayBack) {
    show("stress:T16");
    const auto ui = draw("STABILITY", 1280);
    EXPECT_FALSE(ui->sees_any("back to"));
    edits::show_stress(edit, "stress:T25");
    ui->frames(2);
    EXPECT_FALSE(ui->sees_any("back to"));
    edits::leave_stress(edit);
    EXPECT_EQ(edit.session.scene, "stress:T25");
}

}  // namespace
}  // namespace kd

#endif
