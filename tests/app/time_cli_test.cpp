// Option --time: which pose is rendered, checked and reported.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/scenes.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::run_kdscope, test::TestFolder;

nlohmann::json rendered(const TestFolder& folder, std::vector<std::string> words) {
    const std::string json = folder.file("out.json");
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"-o", folder.file("out.png"), "--size", "16x16", "--json", json});
    const auto outcome = run_kdscope(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return nlohmann::json::parse(read_file(json));
}

TEST(TimeOption, ResultsSayTimeAndDuration) {
    const TestFolder folder;
    const nlohmann::json moved = rendered(folder, {"sheet:200", "--time", "5.5"});
    EXPECT_EQ(moved["scene"]["time"], 1.5) << "it repeats after 4 s";
    EXPECT_EQ(moved["scene"]["duration"], 4.0);
    EXPECT_EQ(moved["settings"]["time"], 5.5) << "as it was asked for";
    const nlohmann::json still = rendered(folder, {"cornell"});
    EXPECT_EQ(still["scene"]["time"], 0.0);
    EXPECT_EQ(still["scene"]["duration"], 0.0);
}

TEST(TimeOption, ChoosesThePose) {
    const TestFolder folder;
    const auto bounds = [&](const char* time) {
        return rendered(folder, {"sheet:200", "--time", time})["scene"]["bounds"];
    };
    EXPECT_NE(bounds("0"), bounds("1.5"));
    EXPECT_EQ(bounds("0"), bounds("-8"));
    EXPECT_EQ(bounds("1.5"), bounds("-2.5"));
}

TEST(TimeOption, StatsNameTheMotion) {
    EXPECT_NE(run_kdscope({"stats", "scatter:50"}).out.find("a motion of 4 s"), std::string::npos);
    EXPECT_EQ(run_kdscope({"stats", "cornell"}).out.find("motion"), std::string::npos);
}

TEST(TimeOption, EveryTracerAgreesInTheMiddleOfAMotion) {
    for (const char* scene : {"ball:300", "scatter:200", "sheet:200"}) {
        const auto outcome = run_kdscope({"verify", scene, "--time", "1.3", "--tracer", "cpu", "--size", "16x16"});
        EXPECT_EQ(outcome.code, 0) << scene << ": " << outcome.out << outcome.err;
    }
}

TEST(LoadScene, TimesOfScenesThatMoveAndOfOthers) {
    EXPECT_EQ(load_scene("sheet:200", 1, 0.5).time, 0.5);
    EXPECT_EQ(load_scene("stress:T14", 1, 0.5).time, 0.0);
    EXPECT_EQ(load_scene("cornell", 1, 0.5).duration, 0.0);
    EXPECT_EQ(scene_text("a", 0.0, 4.0), "a");
    EXPECT_EQ(scene_text("a", 0.25, 4.0), "a at 0.25 s of 4 s");
}

}  // namespace
}  // namespace kd
