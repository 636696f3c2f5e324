// What errortime fails for, by the command line and by reports that nobody measured.

#include "app/error_time/error_time_faults.h"

#include <gtest/gtest.h>

#include "app/error_time/error_time_page.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::Outcome;
using test::run_kdscope;

std::string text_of(const std::vector<ErrorTimeFault>& faults) {
    std::string text;
    for (const ErrorTimeFault& fault : faults) text += fault.where() + ": " + fault.what + '\n';
    return text;
}

TEST(ErrorTimeFaults, ATraversalThatChangesTheImageFailsTheCommand) {
    const test::TestFolder folder;
    const auto run = [&](const std::string& rules) {
        return run_kdscope({"errortime", "--quick", "--seconds", "1", "--report", "P1", "--tracer", "cpu", "--rules",
                            rules, "-o", folder.file(rules), "stress:T10"});
    };
    // What restarting loses under the rules of the first edition, a stack does not.
    const Outcome outcome = run("first-edition");
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("kdscope: P1 of stress:T10: traversals on cpu differ in RMSE by up to "),
              std::string::npos)
        << outcome.err;
    const std::string page = read_file(folder.file("first-edition/index.html"));
    EXPECT_NE(page.find("<b>Wrong</b>: P1 of stress:T10"), std::string::npos);
    const Outcome robust = run("robust");
    EXPECT_EQ(robust.code, 0) << robust.err;
    EXPECT_EQ(read_file(folder.file("robust/index.html")).find("Wrong"), std::string::npos);
}

TEST(ErrorTimeFaults, RaysAreLostByFaultWhereNoneMayBe) {
    ErrorTimeResults results;
    HitRow row;
    row.family = "T15";
    row.n = 1000;
    results.hits = HitReport{{row}, 1000, true};
    EXPECT_EQ(text_of(faults_of(results)), "");
    HitRow& lost = results.hits->rows[0];
    lost.missed = 1;
    lost.wrong = 2;
    EXPECT_EQ(text_of(faults_of(results)),
              "P2 of T15: watertight, float, robust, stack: 3 of 1000 rays are missed or wrong\n");
    const test::TestFolder folder;
    (void)write_error_time(folder.folder(), results, {});
    const std::string page = read_file(folder.file("index.html"));
    EXPECT_NE(page.find("<b>Wrong</b>: P2 of T15"), std::string::npos);
    EXPECT_NE(page.find(": a fault.</p>"), std::string::npos);
    lost.method.rules = Rules::as_published;
    EXPECT_EQ(text_of(faults_of(results)), "") << "these rules promise nothing";
    lost.method = {.test = TriangleTest::moeller_trumbore};
    EXPECT_EQ(text_of(faults_of(results)), "") << "nor does this test";
}

TEST(ErrorTimeFaults, LinesThatPayAnotherCostAreAFaultOfP3Alone) {
    ErrorTimeResults results;
    SceneErrorTime& scene = results.scenes.emplace_back();
    scene.name = {"made:1", "made-1"};
    TreeRow row;
    row.builder = "builder a";
    row.leaf_size = 2;
    row.line_ratios.tests = {1.2, {1.19, 1.21}};
    scene.trees.emplace().rows = {row};
    EXPECT_EQ(text_of(faults_of(results)),
              "P3 of made:1: builder a, leaves of 2: what lines pay is off the prediction by 20.00 %\n");
    results.config.reports = {ErrorReport::p4};
    EXPECT_EQ(text_of(faults_of(results)), "");
    results.config.reports = {ErrorReport::p3};
    scene.trees->rows[0].line_ratios.tests.interval = {1.01, 1.39};
    EXPECT_EQ(text_of(faults_of(results)), "") << "too few lines to tell";
}

}  // namespace
}  // namespace kd
