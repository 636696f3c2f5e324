// How large the frames are that the engine traces and times, and what it says of them.
#include "tests/app/engine_run.h"

namespace kd {
namespace {

TEST(Engine, TimesFramesOfTheSizeThatIsAskedFor) {
    Engine engine(small_session(), EngineOptions{});
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.rounds.size() >= 2; }));
    engine.allow_duel(true, 4);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.scale == 4; }));
    EXPECT_EQ(engine.state().duel.width, 16);
    EXPECT_EQ(engine.state().duel.height, 12);
    EXPECT_TRUE(engine.state().duel.chosen);
    EXPECT_EQ(engine.state().duel.rounds.size(), 1u) << "rounds of another size do not count";
}

TEST(Engine, KeepsItsRoundsWhenTheOtherMachineMakesThePicture) {
    EngineOptions options;
    options.open_gl = [] { return Context::create(ContextKind::automatic); };
    Engine engine(small_session(), options);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.gl.known; }));
    if (!engine.state().gl.available()) GTEST_SKIP() << "NO CONTEXT: " << engine.state().gl.unavailable;
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return s.duel.rounds.size() >= 2; }));
    const std::size_t rounds = engine.state().duel.rounds.size();
    Session session = engine.state().session;
    session.tracer = TracerKind::gl_fragment;
    engine.set_session(session);
    engine.poll();
    EXPECT_FALSE(engine.state().duel.outdated);
    EXPECT_GE(engine.state().duel.rounds.size(), rounds);
    session.trace.traversal = Traversal::restart;
    engine.set_session(session);
    engine.poll();
    EXPECT_TRUE(engine.state().duel.outdated);
    session.trace.traversal = Traversal::stack;
    engine.set_session(session);
    engine.poll();
    EXPECT_FALSE(engine.state().duel.outdated);
    EXPECT_GE(engine.state().duel.rounds.size(), rounds);
}

TEST(DuelScale, IsChosenOnceAndKeptUnlessFramesGetFarTooSlow) {
    double whole_ms = 600;
    const auto predicted = [&](int scale) { return whole_ms / (scale * scale); };
    int scale = duel_scale(0, predicted);
    EXPECT_EQ(scale, 2);
    for (const double ms : {400.0, 10.0, 900.0, 2100.0, 7000.0}) {
        whole_ms = ms;
        EXPECT_EQ(duel_scale(scale, predicted), 2) << ms;
    }
    whole_ms = 9000;
    EXPECT_EQ(duel_scale(scale, predicted), 8);
    EXPECT_EQ(duel_scale(0, [](int) { return 0.0; }), 1) << "the speed is not known";
    EXPECT_EQ(duel_scale(0, [](int) { return 1e9; }), LevelPlan::coarsest);
}

DuelRound round_of(double cpu_ms, double gl_ms) {
    DuelRound round;
    round.cpu.ms = cpu_ms;
    round.gl.ms = gl_ms;
    return round;
}

TEST(DuelState, SaysWhoIsFasterOnceAnIntervalCanBeHad) {
    DuelState duel;
    for (const double cpu : {10.0, 30.0, 20.0, 21.0, 19.0}) duel.add(round_of(cpu, 20));
    duel.add(round_of(10, -1));  // without a GPU
    EXPECT_FALSE(duel.decided());
    duel.add(round_of(20, 20));
    EXPECT_TRUE(duel.decided());
    EXPECT_EQ(duel.ratio.samples, DuelState::least_rounds);
    EXPECT_DOUBLE_EQ(duel.ratio.median, 1);
    EXPECT_TRUE(duel.ratio.holds(1));
    EXPECT_EQ(duel.cpu.samples, 7);
    EXPECT_EQ(duel.gl.samples, 6);
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

TEST(LevelPlan, MovesAsFineAsTimeAllows) {
    LevelPlan plan;
    EXPECT_EQ(plan.moving(1600, 900), plan.first(1600, 900)) << "of unknown speed";
    plan.learn(1000, 1600 * 900);
    EXPECT_EQ(plan.moving(1600, 900), 4) << "1000 / 16 ms; a half along each side would take 250";
    plan.reset();
    plan.learn(150, 1600 * 900);
    EXPECT_EQ(plan.moving(1600, 900), 1);
}

TEST(LevelPlan, GoesStraightToEveryPixelWhereThatIsFast) {
    LevelPlan plan;
    plan.learn(5, 1600 * 900);
    plan.learn(5, 1600 * 900);
    EXPECT_EQ(plan.first(1600, 900), 1);
}

}  // namespace
}  // namespace kd
