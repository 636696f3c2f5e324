// The engine without a window: one way from session to picture, whatever happens on the way.
#include "app/engine.h"

#include <chrono>
#include <gtest/gtest.h>
#include <limits>
#include <thread>

#include "renderer/trace/counters.h"

namespace kd {
namespace {

using namespace std::chrono_literals;

Session small_session(const std::string& scene = "ball:300") {
    Session session;
    session.scene = scene;
    session.width = 64;
    session.height = 48;
    session.threads = 1;
    return session;
}

EngineOptions quiet() {
    EngineOptions options;
    options.duel = false;
    return options;
}

/// Polls until `done` holds; false after ten seconds.
template <class Done>
bool wait_until(Engine& engine, const Done& done) {
    for (int i = 0; i < 10000; ++i) {
        engine.poll();
        if (done(engine.state())) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

bool settle(Engine& engine) {
    return wait_until(engine, [](const EngineState& s) { return !s.stale() && !s.working(); });
}

bool has_error(const EngineState& state, const std::string& part) {
    for (const Message& message : state.messages)
        if (message.error && message.text.find(part) != std::string::npos) return true;
    return false;
}

TEST(Engine, ShowsTheWholePictureOfTheSessionItStartsWith) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const EngineState& state = engine.state();
    EXPECT_EQ(state.picture->image.width, 64);
    EXPECT_EQ(state.picture->image.height, 48);
    EXPECT_EQ(state.picture->traced.scale, 1);
    EXPECT_EQ(state.world->stats.triangles, std::int64_t(state.world->scene().triangles.size()));
    ASSERT_TRUE(state.picture->map);
    EXPECT_EQ(state.picture->map->summary.count, 64 * 48);
    EXPECT_TRUE(state.picture->map->labels.values.empty());
    EXPECT_TRUE(state.messages.empty());
}

TEST(Engine, SameSessionSamePicture) {
    Session session = small_session();
    session.trace.traversal = Traversal::restart;
    Engine a(session, quiet());
    Engine b(small_session("rooms"), quiet());
    ASSERT_TRUE(settle(b));
    b.set_session(session);  // by another way
    ASSERT_TRUE(settle(a));
    ASSERT_TRUE(settle(b));
    EXPECT_EQ(a.state().picture->image, b.state().picture->image);
}

TEST(Engine, TheLatestOfManySessionsWins) {
    Engine engine(small_session(), quiet());
    Session session = small_session();
    for (int i = 0; i < 40; ++i) {
        session.scene = i % 2 ? "ball:300" : "ball:200";
        session.build.leaf_size = 1 + i;
        session.width = 40 + i;
        engine.set_session(session);
        engine.poll();
    }
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world->loaded->name, "ball:300");
    EXPECT_EQ(engine.state().world->built_with.leaf_size, 40);
    EXPECT_EQ(engine.state().picture->image.width, 79);
}

TEST(Engine, AnUnknownSceneKeepsTheOldOneAndSaysWhy) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const Image<Rgba8> before = engine.state().picture->image;
    Session session = small_session("no-such-scene.gltf");
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "no-such-scene.gltf"));
    EXPECT_EQ(engine.state().session.scene, "ball:300");
    EXPECT_EQ(engine.state().picture->image, before);
}

TEST(Engine, ARefusedConstantOfTheTreeIsTakenBack) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = small_session();
    session.build.builder = "no-such-builder";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "no-such-builder"));
    EXPECT_EQ(engine.state().session.build, BuildConfig{});
}

TEST(Engine, AnUnknownMapIsTakenBack) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = small_session();
    session.view.map.map = "no-such-map";
    engine.set_session(session);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.messages.empty(); }));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().session.view.map.map, "nodes");
}

TEST(Engine, AnInvalidCameraLeavesTheLastGoodOne) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    session.camera = Camera{.eye = Vec3(3, 2, 1)};
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    const Camera good = engine.state().camera;
    const std::uint64_t generation = engine.state().generation;
    for (const Camera& bad : {Camera{.eye = Vec3(std::numeric_limits<float>::quiet_NaN())},
                              Camera{.eye = Vec3(1), .target = Vec3(1)}, Camera{.fov_y_degrees = 0}}) {
        session.camera = bad;
        engine.set_session(session);
        ASSERT_TRUE(settle(engine));
        EXPECT_EQ(engine.state().camera, good);
        EXPECT_EQ(engine.state().generation, generation) << "nothing was done again";
    }
}

TEST(Engine, APictureWithoutPixelsIsNotAskedFor) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    Session session = engine.state().session;
    session.width = 0;
    session.height = -5;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->image.width, 64);
    EXPECT_EQ(engine.state().picture->image.height, 48);
}

TEST(Engine, OtherColoursDoNotTraceAgain) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    const auto frame = engine.state().picture->traced.frame;
    Session session = engine.state().session;
    session.view.heat.colormap = "magma";
    engine.set_session(session);
    EXPECT_TRUE(engine.state().stale());
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->traced.frame, frame);
    EXPECT_EQ(engine.state().picture->view.heat.colormap, "magma");
}

TEST(Engine, ACancelledBuildKeepsTheTreeBefore) {
    Session session = small_session("scatter:60000");
    session.build.builder = "spatial-median";
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    const auto world = engine.state().world;
    session = engine.state().session;
    session.build.builder = "paper";
    engine.set_session(session);
    ASSERT_TRUE(engine.state().building.active);
    EXPECT_EQ(engine.state().picture->traced.world, world) << "the old tree stays shown";
    const auto start = std::chrono::steady_clock::now();
    engine.cancel_build();
    ASSERT_TRUE(settle(engine));
    EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
    EXPECT_EQ(engine.state().world, world);
    EXPECT_EQ(engine.state().session.build.builder, "spatial-median");
}

TEST(Engine, ReadsThePixelsThatTheFrameHolds) {
    Engine engine(small_session(), quiet());
    ASSERT_TRUE(settle(engine));
    engine.set_probes(PixelPosition{32, 24}, PixelPosition{1, 2});
    const EngineState& state = engine.state();
    const Frame& frame = *state.picture->traced.frame;
    ASSERT_TRUE(state.hovered && state.pinned);
    EXPECT_EQ(state.hovered->primary().counters, frame.layer(Pass::rt_prim).counters.at(32, 24));
    EXPECT_EQ(state.pinned->primary().hit.triangle, frame.layer(Pass::rt_prim).hit.at(1, 2).triangle);
    EXPECT_TRUE(state.ray_cells.empty());
    engine.set_probes(PixelPosition{64, 0}, std::nullopt);
    EXPECT_FALSE(engine.state().hovered) << "outside";
    EXPECT_FALSE(engine.state().pinned);
}

TEST(Engine, ShowsTheCellsOfARayWithTheSplits) {
    Session session = small_session();
    session.view.overlay.show = true;
    Engine engine(session, quiet());
    ASSERT_TRUE(settle(engine));
    engine.set_probes(PixelPosition{32, 24}, std::nullopt);
    EXPECT_FALSE(engine.state().ray_cells.empty());
}

TEST(Engine, WithoutAGpuTheCpuTracesAndOneLineSaysWhy) {
    Session session = small_session();
    session.tracer = TracerKind::gl_fragment;
    EngineOptions options = quiet();
    options.open_gl = []() -> std::unique_ptr<Context> { throw ContextError("this machine has none"); };
    Engine engine(session, options);
    ASSERT_TRUE(settle(engine));
    EXPECT_TRUE(has_error(engine.state(), "this machine has none"));
    EXPECT_EQ(engine.state().session.tracer, TracerKind::cpu);
    EXPECT_FALSE(engine.state().gl.available());
}

TEST(Engine, MeasuresTheSameFrameAgainAndAgainWhileIdle) {
    EngineOptions options = quiet();
    options.duel = true;
    Engine engine(small_session(), options);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.rounds.size() >= 2; }));
    const DuelState& duel = engine.state().duel;
    EXPECT_EQ(duel.width, 64);
    EXPECT_EQ(duel.cpu.samples, int(duel.rounds.size()));
    EXPECT_GT(duel.cpu.median_ms, 0);
    EXPECT_LT(duel.rounds.back().gl_ms, 0) << "no GPU here";
    EXPECT_GE(duel.rays, 64 * 48);
    engine.note_input();
    EXPECT_FALSE(engine.state().duel.running);
}

TEST(Engine, EndsAtOnceInTheMiddleOfWork) {
    const auto start = std::chrono::steady_clock::now();
    {
        Session session = small_session("ball:2000");
        session.trace.traversal = Traversal::naive;
        session.width = session.height = 1000;
        Engine engine(session, quiet());
        ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.tracing.active; }));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

TEST(LevelPlan, StartsCoarseWhileTheSpeedIsUnknownAndEndsWithEveryPixel) {
    LevelPlan plan;
    EXPECT_EQ(plan.first(1600, 900), 16);
    EXPECT_EQ(plan.first(8, 8), 1) << "a picture of few pixels has no steps";
    plan.learn(1000, 1600 * 900);  // 1 s per picture
    int scale = plan.first(1600, 900);
    EXPECT_LE(plan.predicted_ms(scale, 1600, 900), LevelPlan::first_frame_ms);
    EXPECT_GT(scale, 1);
    int steps = 0;
    while (scale != 1 && ++steps < 10) scale = plan.next(scale, 1600, 900);
    EXPECT_EQ(scale, 1);
    plan.reset();
    EXPECT_EQ(plan.predicted_ms(1, 1600, 900), 0);
}

TEST(LevelPlan, GoesStraightToEveryPixelWhereThatIsFast) {
    LevelPlan plan;
    plan.learn(5, 1600 * 900);
    plan.learn(5, 1600 * 900);
    EXPECT_EQ(plan.first(1600, 900), 1);
}

}  // namespace
}  // namespace kd
