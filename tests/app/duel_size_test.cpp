// The size of the frames that CPU and GPU are timed with: asked for, or chosen once and kept.
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "app/engine.h"

namespace kd {
namespace {

TEST(Engine, TimesFramesOfTheSizeThatIsAskedFor) {
    Session session;
    session.scene = "ball:300";
    session.width = 64;
    session.height = 48;
    Engine engine(session, EngineOptions{});
    const auto wait_until = [&](const auto& done) {
        for (int i = 0; i < 10000 && !done(engine.state().duel); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            engine.poll();
        }
        return done(engine.state().duel);
    };
    ASSERT_TRUE(wait_until([](const DuelState& duel) { return duel.rounds.size() >= 2; }));
    engine.allow_duel(true, 4);
    ASSERT_TRUE(wait_until([](const DuelState& duel) { return duel.scale == 4; }));
    EXPECT_EQ(engine.state().duel.width, 16);
    EXPECT_EQ(engine.state().duel.height, 12);
    EXPECT_TRUE(engine.state().duel.chosen);
    EXPECT_EQ(engine.state().duel.rounds.size(), 1u) << "rounds of another size do not count";
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

}  // namespace
}  // namespace kd
