// The motion of a scene in the engine: poses on demand and one after another, each traced from one state.
#include <set>

#include "app/scenes.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/refit.h"
#include "tests/app/engine_run.h"

namespace kd {
namespace {

constexpr const char* moving_scene = "sheet:200";

Session session_at(double time) {
    Session session = small_session(moving_scene);
    session.time = time;
    return session;
}

/// The tree that a pose should have.
KdTree tree_of(const World& world) {
    const std::vector<Triangle>& triangles = world.scene().triangles;
    if (!world.refitted) return build_tree(triangles, world.built_with);
    const std::vector<Triangle>& rest = world.loaded->moving->at_rest().triangles;
    return refit_tree(build_tree(rest, world.built_with), rest.size(), triangles, world.built_with).value();
}

/// Scene, tree and frame are all of the time that the picture says.
void expect_one_state(const TracedFrame& traced) {
    const World& world = *traced.world;
    const MovingScene alone = open_moving_scene(moving_scene, 1);
    const FlatScene scene = alone.at(world.loaded->time);
    EXPECT_EQ(world.scene().time, scene.time);
    EXPECT_EQ(world.scene().triangles, scene.triangles) << world.loaded->time;
    EXPECT_EQ(world.tree, tree_of(world)) << world.loaded->time;
    Frame frame(traced.frame->width, traced.frame->height);
    const KdTree tree = tree_of(world);
    CpuTracer tracer(scene, tree);
    tracer.trace_frame(traced.config, traced.lens, frame, 1);
    EXPECT_EQ(frame.colour, traced.frame->colour) << world.loaded->time;
}

TEST(EngineMotion, ATimeIsPosedAndNotLoadedAnew) {
    Engine engine(session_at(0), quiet());
    ASSERT_TRUE(settle(engine));
    const auto moving = engine.state().world->loaded->moving;
    const Image<Rgba8> first = engine.state().picture->image;
    ASSERT_TRUE(moving);
    Session session = engine.state().session;
    for (const double time : {1.5, -2.5}) {  // the same place
        session.time = time;
        engine.set_session(session);
        ASSERT_TRUE(settle(engine));
        EXPECT_EQ(engine.state().world->loaded->moving, moving);
        EXPECT_EQ(engine.state().session.time, time);
        EXPECT_EQ(engine.state().time_shown(), 1.5);
        expect_one_state(engine.state().picture->traced);
    }
    Engine alone(session_at(1.5), quiet());
    ASSERT_TRUE(settle(alone));
    EXPECT_EQ(engine.state().picture->image, alone.state().picture->image);
    EXPECT_NE(engine.state().picture->image, first);
    session.time = 0;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->image, first);
}

TEST(EngineMotion, ATimeOfASceneThatDoesNotMoveChangesNothing) {
    Engine engine(small_session("cornell"), quiet());
    ASSERT_TRUE(settle(engine));
    const auto world = engine.state().world;
    Session session = engine.state().session;
    session.time = 1;
    engine.set_session(session);
    engine.play({.playing = true});
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world, world);
    EXPECT_FALSE(engine.state().motion.playing);
}

TEST(EngineMotion, EveryFramePlayedIsOfOneState) {
    for (const FrameSchedule schedule : window_schedules)
        for (const bool refit : {false, true}) {
            SCOPED_TRACE(frame_schedule_names[std::size_t(schedule)]);
            Engine engine(session_at(0.5), quiet());
            ASSERT_TRUE(settle(engine));
            engine.play({.playing = true, .schedule = schedule, .refit = refit});
            std::shared_ptr<const Picture> seen = engine.state().picture;
            for (int frame = 0; frame < 12; ++frame) {
                ASSERT_TRUE(wait_until(engine, [&](const EngineState& s) { return s.picture != seen; }));
                seen = engine.state().picture;
                expect_one_state(seen->traced);
                EXPECT_TRUE(engine.state().motion.playing);
            }
            EXPECT_EQ(seen->traced.world->refitted, refit);
            EXPECT_GT(engine.state().motion.played, 6);
            EXPECT_EQ(engine.state().motion.first_cost > 0, refit);
        }
}

TEST(EngineMotion, AScheduleIsWhatItsStepsSay) {
    for (const FrameSchedule schedule : window_schedules) {
        Session session = session_at(0);
        session.width = 256;
        session.height = 192;
        Engine engine(session, quiet());
        ASSERT_TRUE(settle(engine));
        engine.play({.playing = true, .schedule = schedule});
        ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.motion.played >= 10; }));
        const PipelineRun& run = engine.state().motion.recent;
        int begun_before = 0;
        for (std::size_t n = 1; n < run.frames.size(); ++n) {
            const FrameSteps &before = run.frames[n - 1], &frame = run.frames[n];
            for (std::size_t step = 0; step < frame.of.size(); ++step) {
                EXPECT_GE(frame.of[step].seconds(), 0);
                EXPECT_TRUE(step == 0 || frame.of[step - 1].end <= frame.of[step].begin) << step;
            }
            EXPECT_GE(frame[FrameStep::upload].begin, before[FrameStep::trace].end) << "one frame is traced at a time";
            EXPECT_GE(frame[FrameStep::update].begin, before[FrameStep::build].end) << "one tree is built at a time";
            begun_before += frame[FrameStep::update].begin < before[FrameStep::trace].end;
        }
        EXPECT_EQ(begun_before > 0, schedule == FrameSchedule::pipelined);
        EXPECT_GT(engine.state().motion.stats[std::size_t(schedule)].frame_ms.size(), 6u);
    }
}

TEST(EngineMotion, WhatIsStoppedIsFinished) {
    Engine engine(session_at(0), quiet());
    ASSERT_TRUE(settle(engine));
    engine.play({.playing = true});
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.motion.played >= 3; }));
    engine.play({});
    ASSERT_TRUE(settle(engine));
    const double time = engine.state().session.time;
    EXPECT_GT(time, 0);
    EXPECT_EQ(engine.state().time_shown(), time);
    EXPECT_EQ(engine.state().picture->traced.scale, 1);
    Engine alone(session_at(time), quiet());
    ASSERT_TRUE(settle(alone));
    EXPECT_EQ(engine.state().picture->image, alone.state().picture->image);
}

TEST(EngineMotion, WithoutALoopItEndsAndBeginsAgain) {
    Engine engine(session_at(3.9), quiet());
    ASSERT_TRUE(settle(engine));
    const MotionWish once{.playing = true, .speed = 4, .loop = false};
    engine.play(once);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.motion.ended; }));
    ASSERT_TRUE(settle(engine));
    EXPECT_FALSE(engine.state().motion.playing);
    EXPECT_NEAR(engine.state().session.time, 4, 1e-9);
    engine.play({});
    engine.play(once);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.motion.played > 0; }));
    EXPECT_LT(engine.state().session.time, 4 - 1e-9);
}

TEST(EngineMotion, ADraggedSliderStarvesNoPose) {
    Engine engine(session_at(0), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    std::set<double> shown;
    ASSERT_TRUE(wait_until(engine, [&](const EngineState& s) {
        shown.insert(s.picture->traced.world->loaded->time);
        session.time += 1e-3;
        engine.set_session(session);
        return shown.size() > 5;
    }));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().time_shown(), place_in_motion(session.time, 4)) << "the newest wins";
}

TEST(EngineMotion, CameraTreeAndSceneChangeWhileItPlays) {
    Engine engine(session_at(0), quiet());
    ASSERT_TRUE(settle(engine));
    engine.play({.playing = true});
    const auto plays_on = [&] {
        const std::int64_t before = engine.state().motion.played;
        return wait_until(engine, [&](const EngineState& s) { return s.motion.played > before + 2; });
    };
    ASSERT_TRUE(plays_on());
    for (int i = 0; i < 8; ++i) {
        Session session = engine.state().session;
        session.camera = engine.state().camera;
        session.camera->eye.x += 0.01f;
        engine.set_session(session);
        ASSERT_TRUE(wait_until(
            engine, [&](const EngineState& s) { return s.picture->traced.camera.eye.x == session.camera->eye.x; }));
    }
    ASSERT_TRUE(plays_on());
    Session session = engine.state().session;
    session.build.leaf_size = 7;
    engine.set_session(session);
    ASSERT_TRUE(plays_on());
    EXPECT_EQ(engine.state().picture->traced.world->built_with.leaf_size, 7);
    expect_one_state(engine.state().picture->traced);
    session = engine.state().session;
    session.scene = "ball:300";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.world->loaded->name == "ball:300"; }));
    ASSERT_TRUE(plays_on()) << "the ball moves too";
    engine.play({});
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->traced.world->loaded->name, "ball:300");
}

}  // namespace
}  // namespace kd
