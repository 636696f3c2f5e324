// P5 and P6 from the command line to their part of the page.

#include <algorithm>

#include "app/error_time/error_time_run.h"
#include "renderer/scene/procedural.h"
#include "tests/app/cli_run.h"
#include "tests/app/error_time_folder.h"

namespace kd {
namespace {

using test::expect_whole_page;
using test::Outcome;
using test::rows_of;
using test::run_kdscope;
namespace fs = std::filesystem;

TEST(ErrorTimeCommand, FramesThatEndEarlyAndSampledLightAreWhole) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "--seconds", "1", "--report", "P5,P6", "--tracer",
                                         "cpu", "-o", out.string(), "cornell"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_whole_page(out);
    for (const char* name : {"p5-cornell.csv", "p5-cornell-depths.csv", "p5-cornell-budgets.csv", "p6-cornell.csv",
                             "p6-cornell-slopes.csv", "p6-cornell-soft-shadows.csv", "p6-cornell-gloss.csv",
                             "p6-cornell-indirect-light.csv", "p6-cornell-all-effects.csv"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
    // 0 to 8 bounces by the first traversal, 32 to 4096 steps by three.
    EXPECT_EQ(rows_of(read_file(out / "p5-cornell.csv")).size(), 1u + 9 + 3 * 8);
    const std::string page = read_file(out / "index.html");
    EXPECT_NE(page.find("there the image is the same, bit for bit"), std::string::npos);
    EXPECT_EQ(page.find("Wrong"), std::string::npos);
}

TEST(ErrorTimeCommand, EffectsThatNoPixelShowsAreLeftOut) {
    const test::TestFolder folder;
    const fs::path out = fs::path(folder.folder()) / "et";
    const Outcome outcome = run_kdscope({"errortime", "--quick", "--seconds", "1", "--report", "P5,P6", "--tracer",
                                         "cpu", "-o", out.string(), "scatter:200", "stress:T03"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = rows_of(read_file(out / "left-out.csv"));
    const auto left_out = [&](const std::string& report, const std::string& scene, const std::string& why) {
        return std::ranges::any_of(
            rows, [&](const auto& row) { return row[0] == report && row[1] == scene && row[2].starts_with(why); });
    };
    EXPECT_TRUE(left_out("P5", "stress:T03", "step budget: the tree is one leaf"));
    EXPECT_TRUE(left_out("P5", "stress:T03", "reflection depth: no surface is reflective"));
    EXPECT_TRUE(left_out("P6", "stress:T03", "gloss: nothing is reflected"));
    expect_whole_page(out);
}

/// P5 and P6 of a small scene on the CPU and on Mesa's software OpenGL.
SceneErrorTime by_both_machines() {
    ErrorTimeConfig config;
    config.reports = {ErrorReport::p5, ErrorReport::p6};
    config.seconds = 1;
    config.quick = true;
    config.context = ContextKind::osmesa;
    config.traversals = {Traversal::stack};
    OpenedScene opened;
    opened.session.scene = "ball:100";
    opened.scene = flatten(*make_procedural("ball:100"));
    return run_error_time(config, {opened}, [](float, const std::string&) {}, {}).scenes.at(0);
}

TEST(ErrorTimeFrames, OpenGlEndsAndSamplesAsTheCpuDoes) {
    const SceneErrorTime scene = by_both_machines();
    for (const LeftOut& left : scene.left_out)
        if (left.why.starts_with("gl-fragment: ")) GTEST_SKIP() << "NO CONTEXT: " << left.why;
    ASSERT_TRUE(scene.truncation && scene.effects);
    std::vector<TruncationCurve> cpu, gl;
    for (const TruncationCurve& curve : scene.truncation->curves) (curve.machine == "cpu" ? cpu : gl).push_back(curve);
    ASSERT_EQ(cpu.size(), 2u) << "bounces and budgets";
    ASSERT_EQ(gl.size(), 2u);
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_TRUE(gl[c].wrong_limits().empty());
        EXPECT_EQ(gl[c].most_steps, cpu[c].most_steps);
        ASSERT_EQ(gl[c].points.size(), cpu[c].points.size());
        for (std::size_t i = 0; i < gl[c].points.size(); ++i) {
            EXPECT_EQ(gl[c].points[i].given_up, cpu[c].points[i].given_up);
            // Colours of the same hits, off by a rounding of 6e-8 here and there.
            EXPECT_NEAR(gl[c].points[i].rmse, cpu[c].points[i].rmse, ImageReport::most_own_gap);
        }
    }
    for (const MeasuredEffect& measured : scene.effects->effects)
        for (const EffectCurve& curve : measured.curves) EXPECT_LE(curve.gap, ImageReport::most_own_gap);
}

}  // namespace
}  // namespace kd
