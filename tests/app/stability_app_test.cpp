// The stability suite on the command line: what was measured, its sweeps, and its scenes by name.

#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <thread>

#include "app/report/json_values.h"
#include "app/scenes.h"
#include "app/session.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

#ifdef KD_WITH_WINDOW
#include "app/panels/edit.h"
#endif

namespace kd {
namespace {

using test::expect_usage_error;
using test::run_kdscope;

/// Of the first row of a case: what the table and the JSON say.
std::pair<std::string, Json> worst_ulp_of(const std::string& id) {
    std::vector<std::string> arguments{"stability", "--case", id, "--tracer", "cpu", "--traversal", "stack"};
    std::istringstream table(run_kdscope(arguments).out);
    std::string cell;
    for (std::string line; std::getline(table, line);) {
        std::istringstream row(line);
        const std::vector<std::string> cells{std::istream_iterator<std::string>(row), {}};
        if (cell.empty() && cells.size() == 10 && cells[0] == id) cell = cells[7];
    }
    arguments.emplace_back("--json");
    return {cell, Json::parse(run_kdscope(arguments).out)["cases"][0]["worst_ulp"]};
}

TEST(Stability, TheWorstErrorOfTIsToldWhereverSomethingIsHit) {
    const auto [no_cell, no_number] = worst_ulp_of("T36");
    EXPECT_EQ(no_cell, "-");
    EXPECT_TRUE(no_number.is_null()) << no_number;
    const auto [cell, number] = worst_ulp_of("T02");
    ASSERT_TRUE(number.is_number()) << number;
    EXPECT_EQ(cell, fmt::format("{:.3g}", number.get<double>()));
    // Rays that graze a plane meet it far from where they exactly do.
    const auto [large_cell, large] = worst_ulp_of("T27");
    EXPECT_GT(large, 1e4);
    EXPECT_NE(large_cell.find("e+"), std::string::npos) << large_cell;
}

TEST(Stability, AChecksRowSaysWhatItIsAndHasNoBound) {
    const std::string out = run_kdscope({"stability", "--case", "T01", "--tracer", "cpu", "--traversal", "stack"}).out;
    EXPECT_EQ(out.find("1.0e+00"), std::string::npos) << out;
    EXPECT_NE(out.find("\ntracer -: a check beside the tracers"), std::string::npos) << out;
}

TEST(Stability, RowsOfCasesThatEndedAreThereAfterAnInterrupt) {
    std::stop_source stop;
    std::jthread after_the_first([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        stop.request_stop();
    });
    const test::Outcome outcome = run_kdscope(
        {"stability", "--case", "T02,T24", "--long", "--tracer", "cpu", "--traversal", "stack"}, stop.get_token());
    EXPECT_EQ(outcome.code, exit_interrupted);
    EXPECT_TRUE(outcome.out.starts_with("case  tracer")) << outcome.out;
    EXPECT_NE(outcome.out.find("\nT02   cpu "), std::string::npos) << outcome.out;
}

TEST(StressScenes, AreScenesWhereverOneIsTaken) {
    EXPECT_TRUE(names_scene("stress:T16"));
    EXPECT_EQ(load_scene("stress:T25=1e-3", 1).triangles.size(), 1000u);
    const test::Outcome stats = run_kdscope({"stats", "stress:T09", "--json"});
    ASSERT_EQ(stats.code, 0) << stats.err;
    EXPECT_EQ(Json::parse(stats.out)[0]["trees"][0]["tree"]["triangles"], 4008);
    expect_usage_error(run_kdscope({"stats", "stress:T999"}), {"there is no stability case 'T999'", "T01 to T65"});
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
    const std::string csv = read_file(folder.file("t.csv"));
    const auto table = csv.find("case,parameter");
    ASSERT_NE(table, std::string::npos);
    EXPECT_EQ(std::ranges::count(csv.substr(table), '\n'), std::ptrdiff_t(json["rows"].size()) + 1);
    EXPECT_NE(csv.substr(0, table).find("# cpu: "), std::string::npos) << "the machine stands before it";
    EXPECT_TRUE(json["measured_on"].contains("cpu"));
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
