// The stability suite behind the window.

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "app/engine.h"

namespace kd {
namespace {

using namespace std::chrono_literals;

Session small_session() {
    Session session;
    session.scene = "ball:300";
    session.width = 32;
    session.height = 24;
    return session;
}

/// Polls until nothing of the suite runs; false after ten minutes, as a sanitizer makes a case take some.
bool rests(Engine& engine) {
    for (int i = 0; i < 600'000; ++i) {
        engine.poll();
        if (!engine.state().stability.active) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

EngineOptions quiet() {
    EngineOptions options;
    options.duel = false;
    return options;
}

TEST(EngineStability, RunsACaseUnderTheRulesOfTheSession) {
    Session session = small_session();
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

TEST(EngineStability, ASweepGrowsAndACancelKeepsWhatItHas) {
    Engine engine(small_session(), quiet());
    engine.run_sweep("T14");
    const auto grown = [&] {
        const auto& sweeps = engine.state().stability.sweeps;
        return sweeps.contains("T14") && !sweeps.at("T14")->rows.empty();
    };
    for (int i = 0; i < 60'000 && !grown(); ++i) {
        engine.poll();
        std::this_thread::sleep_for(1ms);
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
    Engine engine(small_session(), quiet());
    engine.run_sweep("T01");
    ASSERT_TRUE(rests(engine));
    EXPECT_NE(engine.state().stability.error.find("case 'T01': has no sweep"), std::string::npos);
    EXPECT_TRUE(engine.state().stability.sweeps.empty());
}

}  // namespace
}  // namespace kd
