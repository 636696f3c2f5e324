// The stability suite, on the CPU and OpenGL.

#include "renderer/measure/stability/stability.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "renderer/geometry/input_error.h"
#include "renderer/gl/context.h"
#include "renderer/measure/stability/case_run.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/traversal.h"

namespace kd {
namespace {

TEST(StabilityCases, EachSaysWhatItIs) {
    std::set<std::string_view> ids;
    int exempt = 0;
    for (const StabilityCase& info : stability_cases()) {
        EXPECT_TRUE(ids.insert(info.id).second) << info.id;
        EXPECT_NE(info.run, nullptr) << info.id;
        for (const std::string_view text : {info.title, info.construction, info.oracle, info.acceptance})
            EXPECT_FALSE(text.empty()) << info.id;
        exempt += !info.exempt.empty();
    }
    EXPECT_TRUE(std::ranges::is_sorted(stability_cases(), {}, &StabilityCase::id));
    EXPECT_TRUE(ids.contains("T14"));
    EXPECT_LE(exempt, 3);
}

StabilityReport run(Rules rules, std::vector<std::string> traversals, std::vector<ContextKind> contexts = {}) {
    StabilityConfig config;
    config.cases = {"T16"};
    config.rules = rules;
    config.traversals = std::move(traversals);
    config.contexts = std::move(contexts);
    return run_stability(config);
}

TEST(Stability, ASpheresVerticesHoldUnderTheRobustRules) {
    const StabilityReport report = run(Rules::robust, {});
    EXPECT_TRUE(report.passed());
    EXPECT_EQ(report.cases_run, 1);
    ASSERT_EQ(report.rows.size(), traversals().size() - 1) << "all but naive";
    for (const StabilityRow& row : report.rows) {
        EXPECT_EQ(row.id, "T16");
        EXPECT_EQ(row.tracer, "cpu");
        EXPECT_EQ(row.n, 100'000) << "a tenth";
        EXPECT_EQ(row.mismatches, 0) << row.reason;
        EXPECT_EQ(row.verdict, Verdict::pass);
        EXPECT_DOUBLE_EQ(row.upper95, 3e-5);
        EXPECT_GT(row.worst_ulp, 0.5) << "of t, which a float rounds";
        EXPECT_LT(row.worst_ulp, 64) << "of rays that graze nothing";
        EXPECT_EQ(row.worst_ulp, report.rows[0].worst_ulp) << "the same hits";
    }
}

TEST(Stability, ASpheresVerticesAreLostAsPublished) {
    const StabilityReport report = run(Rules::as_published, {"stack"});
    EXPECT_FALSE(report.passed());
    ASSERT_EQ(report.rows.size(), 1u);
    const StabilityRow& row = report.rows[0];
    EXPECT_EQ(row.verdict, Verdict::fail);
    EXPECT_GT(row.mismatches, 0);
    EXPECT_GT(row.upper95, double(row.mismatches) / double(row.n));
    EXPECT_NE(row.reason.find("0x"), std::string::npos) << "the ray in exact hexadecimal floats: " << row.reason;
}

/// Why there is no OSMesa, empty where there is.
std::string why_no_osmesa() {
    try {
        return Context::create(ContextKind::osmesa)->is_software() ? "" : "not in software";
    } catch (const ContextError& error) {
        return error.what();
    }
}

TEST(Stability, OpenGlIsHeldToTheSame) {
    if (const std::string why = why_no_osmesa(); !why.empty()) GTEST_SKIP() << "NO CONTEXT: " << why;
    const StabilityReport report = run(Rules::robust, {"restart"}, {ContextKind::osmesa});
    EXPECT_TRUE(report.passed());
    ASSERT_EQ(report.rows.size(), 2u);
    EXPECT_EQ(report.rows[1].tracer, "gl-fragment");
    EXPECT_EQ(report.rows[1].context, "osmesa");
    EXPECT_EQ(report.rows[1].n, report.rows[0].n);
}

TEST(Stability, EveryWalkIsHeldToTheCpuOnOpenGl) {
    StabilityConfig config;
    config.cases = {"T62"};
    config.contexts = {ContextKind::osmesa};
    if (const std::string why = why_no_osmesa(); !why.empty()) GTEST_SKIP() << "NO CONTEXT: " << why;
    const StabilityReport report = run_stability(config);
    EXPECT_TRUE(report.passed());
    const auto part = std::int64_t(100'000 + builders().size() - 1) / std::int64_t(builders().size());
    const std::int64_t of_all = part * std::int64_t(builders().size());
    const std::map<std::string, std::int64_t> rays{
        {"stack", 2 * of_all},     {"restart", 2 * of_all},         {"backtrack", of_all},  // nodes of 16 bytes alone
        {"push-down", 2 * of_all}, {"short-stack", 4 * 2 * of_all}, {"ropes", 2 * 2 * of_all}};
    std::map<std::string, std::map<std::string, std::int64_t>> walked;  // by tracer
    for (const StabilityRow& row : report.rows) walked[row.tracer][row.traversal] = row.n;
    EXPECT_EQ(walked["cpu"], rays);
    EXPECT_EQ(walked["gl-fragment"], rays);
}

TEST(Stability, NaiveIsAskedOnlyOfTracersThatHaveIt) {
    if (const std::string why = why_no_osmesa(); !why.empty()) GTEST_SKIP() << "NO CONTEXT: " << why;
    StabilityConfig config;
    config.cases = {"T50"};
    config.cpu = {};
    config.gl = {GlMode::fragment, GlMode::wavefront};
    config.contexts = {ContextKind::osmesa};
    const StabilityReport report = run_stability(config);
    EXPECT_TRUE(report.passed());
    std::set<std::string> tracers;
    for (const StabilityRow& row : report.rows)
        if (row.traversal == info(Traversal::naive).name) tracers.insert(row.tracer);
    EXPECT_EQ(tracers, std::set<std::string>{"gl-fragment"});
}

TEST(Stability, TreesAreOfTheBuilderAskedForWhereACaseNamesNone) {
    StabilityConfig config;
    config.builder = "spatial-median";
    CaseRun run(stability_case("T16"), config, {}, {});
    const std::vector<Triangle> sphere = stress_sphere(16, 8);
    EXPECT_EQ(run.subject(sphere).tree, build_tree(sphere, {.builder = "spatial-median"}));
    EXPECT_EQ(run.subject(sphere, BuildConfig{}).tree, build_tree(sphere, {}));
}

TEST(Stability, UnknownCasesAreRefusedBeforeAnyWork) {
    StabilityConfig config;
    config.cases = {"T14", "T999"};
    bool started = false;
    try {
        (void)run_stability(config, [&](float, const std::string&, const StabilityReport&) { started = true; });
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "there is no stability case 'T999'; there are T01 to T65, without T17, T39, T53, T56");
    }
    EXPECT_FALSE(started);
}

TEST(Stability, ProgressMovesWithinACaseAndNeverBack) {
    StabilityConfig config;
    config.cases = {"T02", "T16"};
    std::map<std::string, std::vector<float>> fractions;  // by case
    float before = 0;
    (void)run_stability(config, [&](float done, const std::string& what, const StabilityReport&) {
        EXPECT_GE(done, before) << what;
        EXPECT_LE(done, 1) << what;
        before = done;
        fractions[what.substr(0, 3)].push_back(done);
    });
    ASSERT_EQ(fractions.size(), 2u);
    for (const auto& [id, told] : fractions) {
        EXPECT_GE(std::set(told.begin(), told.end()).size(), traversals().size() - 1) << id << ": a step for each";
        EXPECT_GT(told.back() - told.front(), 0.1f) << id;
    }
    EXPECT_LE(fractions["T02"].back(), 0.5f);
    EXPECT_EQ(fractions["T16"].front(), 0.5f) << "half of the cases";
}

TEST(Stability, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const StabilityReport report = run_stability({}, {}, stop.get_token());
    EXPECT_FALSE(report.complete);
    EXPECT_FALSE(report.passed());
}

TEST(Stability, RowsAreToldAsTheyEndAndAStopKeepsThem) {
    StabilityConfig config;
    config.cases = {"T02", "T16"};
    config.traversals = {"stack", "restart"};
    std::stop_source stop;
    std::vector<std::string> seen;  // rows whenever something is told
    const auto look = [&](float, const std::string& what, const StabilityReport& so_far) {
        EXPECT_FALSE(so_far.complete);
        seen.push_back(what.substr(0, 3) + fmt::format(" {} cases", so_far.cases_run));
        for (const StabilityRow& row : so_far.rows) seen.back() += " " + row.id + row.traversal;
        if (so_far.rows.size() == 4) stop.request_stop();
    };
    const StabilityReport report = run_stability(config, look, stop.get_token());
    EXPECT_EQ(seen[0], "T02 0 cases");
    EXPECT_NE(std::ranges::find(seen, "T16 1 cases T02stack T02restart T02u, v, t, point"), seen.end());
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.cases_run, 1);
    ASSERT_EQ(report.rows.size(), 4u) << "and the walk that was stopped has none";
    EXPECT_EQ(report.rows[3].id, "T16");
    EXPECT_EQ(report.rows[3].n, 100'000);
    EXPECT_EQ(report.rows[3].verdict, Verdict::pass);
}

TEST(StabilityReport, PassesOnlyWhereSomethingRanAndNothingFailed) {
    StabilityReport report;
    EXPECT_FALSE(report.passed());
    report.rows.resize(2);
    EXPECT_TRUE(report.passed());
    report.rows[1].verdict = Verdict::exempt;
    EXPECT_TRUE(report.passed());
    report.rows[0].verdict = Verdict::fail;
    EXPECT_FALSE(report.passed());
}

TEST(Stability, AnExemptionExcusesWhatWasGivenUpAndNothingElse) {
    StabilityConfig config;
    config.cases = {"T24"};
    config.traversals = {"restart"};
    config.contexts = {ContextKind::osmesa};
    try {
        (void)Context::create(ContextKind::osmesa);
    } catch (const ContextError& error) {
        GTEST_SKIP() << "NO CONTEXT: " << error.what();
    }
    for (const StabilityRow& row : run_stability(config).rows) {
        if (row.tracer == "-") continue;  // its picture
        EXPECT_EQ(row.given_up, row.mismatches) << row.reason;
        EXPECT_EQ(row.verdict, row.tracer == "cpu" ? Verdict::pass : Verdict::exempt) << row.reason;
    }
    // Leaves of more triangles than a shader has steps: no ray through them may pass for answered.
    config.cases = {"T04"};
    for (const StabilityRow& row : run_stability(config).rows) {
        if (row.tracer != "gl-fragment") continue;
        EXPECT_GT(row.given_up, 0);
        EXPECT_EQ(row.verdict, Verdict::exempt);
        EXPECT_NE(row.reason.find("0x"), std::string::npos) << "a ray in exact floats: " << row.reason;
    }
    config.cases = {"T24"};
    config.rules = Rules::as_published;  // wrong without a flag
    for (const StabilityRow& row : run_stability(config).rows) {
        if (row.tracer == "-") continue;
        EXPECT_LT(row.given_up, row.mismatches);
        EXPECT_EQ(row.verdict, Verdict::fail) << row.tracer;
    }
}

}  // namespace
}  // namespace kd
