// What panels and keys do to the motion of the scene.
#ifdef KD_WITH_WINDOW

#include <gtest/gtest.h>

#include "app/panels/edit.h"

namespace kd {
namespace {

EngineState state_of(double duration) {
    const auto loaded = std::make_shared<LoadedScene>();
    loaded->flat.duration = duration;
    const auto world = std::make_shared<World>();
    world->loaded = loaded;
    EngineState state;
    state.world = world;
    return state;
}

TEST(MotionEdit, StepsGoRoundAndStopTheMotion) {
    const EngineState state = state_of(4);
    Edit edit;
    edit.window.motion.playing = true;
    edits::step_motion(state, edit, 1);
    EXPECT_DOUBLE_EQ(edit.session.time, 1.0 / 30);
    EXPECT_FALSE(edit.window.motion.playing);
    edits::step_motion(state, edit, -2);
    EXPECT_DOUBLE_EQ(edit.session.time, 4 - 1.0 / 30);
    edits::seek(state, edit, 4);
    EXPECT_EQ(edit.session.time, 0);
}

TEST(MotionEdit, NothingIsPlayedThatDoesNotMove) {
    const EngineState still = state_of(0);
    Edit edit;
    edits::toggle_playing(still, edit);
    EXPECT_FALSE(edit.window.motion.playing);
    EXPECT_EQ(edit.window.bottom, motion_panel) << "which says so";
    edits::step_motion(still, edit, 1);
    EXPECT_EQ(edit.session.time, 0);
    edit.window.motion.playing = true;
    edits::settle_motion(still, edit);
    EXPECT_FALSE(edit.window.motion.playing);
}

TEST(MotionEdit, AnotherSceneBeginsAtItsBeginning) {
    Edit edit;
    edit.session.time = 1.5;
    edits::choose_scene(edit, "ball:300");
    EXPECT_EQ(edit.session.time, 0);
}

TEST(MotionEdit, SpaceAgainStopsAndTheEndDoesToo) {
    EngineState state = state_of(4);
    Edit edit;
    edits::toggle_playing(state, edit);
    EXPECT_TRUE(edit.window.motion.playing);
    edits::settle_motion(state, edit);
    EXPECT_TRUE(edit.window.motion.playing);
    edits::toggle_playing(state, edit);
    EXPECT_FALSE(edit.window.motion.playing);
    edits::toggle_playing(state, edit);
    state.motion.ended = true;
    edits::settle_motion(state, edit);
    EXPECT_FALSE(edit.window.motion.playing);
}

}  // namespace
}  // namespace kd

#endif
