// The stability suite behind the window.

#include "tests/app/engine_run.h"

namespace kd {
namespace {

/// A small picture, which nobody looks at.
Session tiny_session() {
    Session session = small_session();
    session.width = 32;
    session.height = 24;
    session.threads = 0;
    return session;
}

/// Polls until nothing of the suite runs: a sanitizer makes a case take some minutes.
bool rests(Engine& engine) {
    return wait_until(
        engine, [](const EngineState& s) { return !s.stability.active; }, 10 * test::patience());
}

TEST(EngineStability, RunsACaseUnderTheRulesOfTheSession) {
    Session session = tiny_session();
    session.trace.rules = Rules::as_published;
    Engine engine(session, quiet());
    engine.run_case("T16", false);
    EXPECT_TRUE(engine.state().stability.active);
    EXPECT_EQ(engine.state().stability.id, "T16");
    ASSERT_TRUE(rests(engine));
    EXPECT_EQ(engine.state().stability.error, "");
    const auto& verdicts = engine.state().stability.verdicts;
    ASSERT_TRUE(verdicts.contains("T16"));
    ASSERT_EQ(verdicts.at("T16")->rows.size(), 1u) << "the session's traversal on the CPU";
    EXPECT_EQ(verdicts.at("T16")->rows[0].traversal, "stack");
    EXPECT_GT(verdicts.at("T16")->rows[0].mismatches, 0);
    EXPECT_FALSE(verdicts.at("T16")->passed());
}

TEST(EngineStability, ACaseTellsHowFarItIs) {
    Engine engine(tiny_session(), quiet());
    engine.run_case("T02", true);
    EXPECT_EQ(engine.state().stability.fraction, 0);
    ASSERT_TRUE(rests(engine));
    EXPECT_GT(engine.state().stability.fraction, 0.2f) << "what was told last";
    EXPECT_LE(engine.state().stability.fraction, 1);
}

TEST(EngineStability, ACancelledCaseKeepsTheRowsThatItHas) {
    Engine engine(tiny_session(), quiet());
    engine.run_case("T38", true);
    EXPECT_EQ(engine.state().stability.what, "") << "queued";
    const auto& verdicts = engine.state().stability.verdicts;
    const auto grown = [&](const EngineState&) { return verdicts.contains("T38"); };
    ASSERT_TRUE(wait_until(engine, grown, 10 * test::patience()));
    EXPECT_FALSE(verdicts.at("T38")->complete);
    EXPECT_NE(engine.state().stability.what, "");
    engine.cancel_stability();
    EXPECT_FALSE(engine.state().stability.active);
    const std::size_t rows = verdicts.at("T38")->rows.size();
    EXPECT_GT(rows, 0u);
    engine.run_case("T02", true);
    ASSERT_TRUE(rests(engine));
    EXPECT_TRUE(verdicts.at("T02")->passed());
    EXPECT_EQ(verdicts.at("T38")->rows.size(), rows);
    EXPECT_FALSE(verdicts.at("T38")->passed());
}

TEST(EngineStability, ASweepGrowsAndACancelKeepsWhatItHas) {
    Engine engine(tiny_session(), quiet());
    engine.run_sweep("T14");
    const auto grown = [&] {
        const auto& sweeps = engine.state().stability.sweeps;
        return sweeps.contains("T14") && !sweeps.at("T14")->rows.empty();
    };
    for (int i = 0; i < 60'000 && !grown(); ++i) {
        engine.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(grown());
    EXPECT_FALSE(engine.state().stability.sweeps.at("T14")->complete);
    engine.cancel_stability();
    EXPECT_FALSE(engine.state().stability.active);
    const std::size_t rows = engine.state().stability.sweeps.at("T14")->rows.size();
    engine.run_case("T02", true);
    ASSERT_TRUE(rests(engine));
    EXPECT_TRUE(engine.state().stability.verdicts.at("T02")->passed());
    EXPECT_EQ(engine.state().stability.sweeps.at("T14")->rows.size(), rows) << "a dropped sweep must not go on";
}

TEST(EngineStability, WhatCannotRunIsToldAndNothingElseHappens) {
    Engine engine(tiny_session(), quiet());
    engine.run_sweep("T01");
    ASSERT_TRUE(rests(engine));
    EXPECT_NE(engine.state().stability.error.find("case 'T01': has no sweep"), std::string::npos);
    EXPECT_TRUE(engine.state().stability.sweeps.empty());
}

}  // namespace
}  // namespace kd
