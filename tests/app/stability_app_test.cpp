// The stability suite behind the window, its sweeps on the command line, and its scenes by name.

#include <chrono>
#include <thread>

#include "app/engine.h"
#include "app/json_values.h"
#include "app/session.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

#ifdef KD_WITH_WINDOW
#include "app/panels/edit.h"
#endif

namespace kd {
namespace {

using namespace std::chrono_literals;
using test::expect_usage_error;
using test::run_kdscope;

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

TEST(StressScenes, AreScenesWhereverOneIsTaken) {
    EXPECT_TRUE(names_scene("stress:T16"));
    EXPECT_EQ(load_scene("stress:T25=1e-3", 1).triangles.size(), 1000u);
    const test::Outcome stats = run_kdscope({"stats", "stress:T09", "--json"});
    ASSERT_EQ(stats.code, 0) << stats.err;
    EXPECT_EQ(Json::parse(stats.out)[0]["trees"][0]["tree"]["triangles"], 4008);
    expect_usage_error(run_kdscope({"stats", "stress:T999"}), {"stress:T999", "there is no case 'T999'"});
    expect_usage_error(run_kdscope({"stats", "stress:T25=9"}), {"stress:T25=9", "1e-09 to 0.1"});
}

TEST(StabilitySweep, WritesJsonCsvAndATable) {
    const std::vector<std::string> sweep{"stability", "--sweep", "T27", "--tracer", "cpu"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), sweep.begin(), sweep.end());
        return run_kdscope(more);
    };
    const test::Outcome outcome = with({"--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["case"], "T27");
    EXPECT_EQ(json["values"].size() * 4, json["rows"].size()) << "three rules on the CPU, and double";
    const test::TestFolder folder;
    EXPECT_EQ(with({"--csv", folder.file("t.csv")}).code, 0);
    EXPECT_EQ(std::ranges::count(read_file(folder.file("t.csv")), '\n'), std::ptrdiff_t(json["rows"].size()) + 1);
    EXPECT_NE(with({}).out.find("angle between ray and plane"), std::string::npos);
}

TEST(StabilitySweep, WhatHasNoneIsRefusedInOneLineNamingThoseThatHave) {
    expect_usage_error(run_kdscope({"stability", "--sweep", "T01"}), {"'T01'", "has no sweep", "T14", "T25"});
    expect_usage_error(run_kdscope({"stability", "--sweep", "T99"}), {"'T99'", "not known", "T14", "T25"});
    expect_usage_error(run_kdscope({"stability", "--sweep", "T14", "--case", "T14"}), {"--case", "--sweep"});
    expect_usage_error(run_kdscope({"stability", "--sweep", "T14", "--rules", "robust"}), {"--rules", "--sweep"});
    expect_usage_error(run_kdscope({"stability", "--csv", "x.csv"}), {"--csv", "--sweep"});
    expect_usage_error(run_kdscope({"stability", "--sweep", "T14", "--csv", "/no/such/folder/x.csv"}), {"--csv"});
}

TEST(StabilitySweep, EndsWhenInterrupted) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(run_kdscope({"stability", "--sweep", "T14"}, stop.get_token()).code, exit_interrupted);
}

#ifdef KD_WITH_WINDOW
TEST(StressScenes, TheSceneBeforeComesBackWithItsCamera) {
    Edit edit;
    edit.session.scene = "rooms";
    edit.session.camera = Camera{.eye = Vec3(1, 2, 3)};
    edits::show_stress(edit, "stress:T16");
    EXPECT_EQ(edit.session.scene, "stress:T16");
    EXPECT_FALSE(edit.session.camera) << "the case's own";
    edits::show_stress(edit, "stress:T16=0.1");
    edits::leave_stress(edit);
    EXPECT_EQ(edit.session.scene, "rooms");
    EXPECT_EQ(edit.session.camera, (Camera{.eye = Vec3(1, 2, 3)}));
}
#endif

}  // namespace
}  // namespace kd
