// render and gallery: the files they write, and those that they leave alone.

#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

TEST(Render, BeautyIsThePictureItself) {
    const TestFolder folder;
    const test::Outcome outcome = run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "40x30"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Image<Rgba8> image = read_png(folder.file("a.png"));
    EXPECT_EQ(image.width, 40);
    EXPECT_EQ(image.height, 30);
    EXPECT_GT(image.at(20, 25).r, 60);  // the lit floor
    EXPECT_NE(outcome.out.find("left out"), std::string::npos) << outcome.out;
    EXPECT_EQ(folder.names(), Words{"a.png"});
}

TEST(Render, MapHasLegendUnlessRefused) {
    const TestFolder folder;
    const Words common{"render", "cornell", "--size", "40x30", "--map", "nodes", "-o"};
    Words with = common, without = common;
    with.push_back(folder.file("with.png"));
    without.insert(without.end(), {folder.file("without.png"), "--no-legend"});
    ASSERT_EQ(run_kdscope(with).code, 0);
    ASSERT_EQ(run_kdscope(without).code, 0);
    EXPECT_GT(read_png(folder.file("with.png")).width, 200);
    EXPECT_EQ(read_png(folder.file("without.png")).width, 40);
}

TEST(Render, PictureCarriesItsSettings) {
    const TestFolder folder;
    ASSERT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "32x32", "--map", "leaves",
                           "--traversal", "restart", "--eye", "0,1,4.5", "--builder", "spatial-median", "--seed", "7"})
                  .code,
              0);
    const PngText text = read_png_text(folder.file("a.png"));
    const json settings = json::parse(text.at("kdscope-settings"));
    EXPECT_EQ(settings["scene"], "cornell");
    EXPECT_EQ(settings["traversal"], "restart");
    EXPECT_EQ(settings["build"]["builder"], "spatial-median");
    EXPECT_EQ(settings["seed"], 7);
    EXPECT_EQ(settings["camera"]["eye"], json::parse("[0, 1, 4.5]"));
    EXPECT_EQ(settings["view"]["map"]["name"], "leaves");
    EXPECT_NE(text.at("Description").find("cornell"), std::string::npos);
    EXPECT_NE(text.at("Description").find(" ms "), std::string::npos);
}

TEST(Render, JsonCountsEveryRay) {
    const TestFolder folder;
    ASSERT_EQ(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "32x24", "--json",
                           folder.file("a.json"), "--csv", folder.file("a.csv"), "--exr", folder.file("a.exr")})
                  .code,
              0);
    const json data = json::parse(read_file(folder.file("a.json")));
    EXPECT_EQ(data["counters"]["primary"]["rays"], 32 * 24);
    for (const char* rays : {"primary", "shadow", "reflection", "reflection_shadow"}) {
        EXPECT_GT(data["counters"][rays]["rays"], 0) << rays;
        EXPECT_GE(data["counters"][rays]["leaves"], data["counters"][rays]["rays"].get<int>() / 2) << rays;
    }
    EXPECT_EQ(data["scene"]["triangles"], 34);
    EXPECT_EQ(data["tree"]["leaves"].get<int>(), data["tree"]["interior"].get<int>() + 1);
    EXPECT_GE(data["ms"]["build"], 0);
    EXPECT_GT(data["ms"]["trace"], 0);
    EXPECT_TRUE(data["renderer"].is_string());
    EXPECT_FALSE(data["left_out"].empty());
    const std::string csv = read_file(folder.file("a.csv"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 32 * 24 + 1);
    EXPECT_EQ(folder.names(), (Words{"a.csv", "a.exr", "a.json", "a.png"}));
}

TEST(Render, OptionsChangeWhatIsTraced) {
    const TestFolder folder;
    const auto rays = [&](const Words& more, const char* kind) {
        Words arguments{"render", "cornell", "-o",     folder.file("a.png"),
                        "--size", "32x32",   "--json", folder.file("a.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run_kdscope(arguments).code, 0);
        return json::parse(read_file(folder.file("a.json")))["counters"][kind]["rays"].get<int>();
    };
    EXPECT_EQ(rays({"--no-shadows"}, "shadow"), 0);
    EXPECT_EQ(rays({"--reflection-depth", "0"}, "reflection"), 0);
    EXPECT_EQ(rays({"--min-contribution", "1"}, "reflection"), 0);
    EXPECT_GT(rays({}, "reflection"), 0);
}

TEST(Render, BadOutputsAreToldBeforeTheWork) {
    const TestFolder folder;
    const auto refused = [&](const Words& outputs, const Words& words) {
        Words arguments{"render", "ball:2000000"};
        arguments.insert(arguments.end(), outputs.begin(), outputs.end());
        const test::Outcome outcome = run_kdscope(arguments);
        expect_usage_error(outcome, words);
        EXPECT_EQ(outcome.out, "");
    };
    refused({"-o", folder.file("none/a.png")}, {"--output", "none/a.png", "no folder"});
    refused({"-o", folder.file("a.jpg")}, {"--output", "a.jpg", ".png"});
    std::filesystem::create_directory(folder.file("dir.png"));
    refused({"-o", folder.file("dir.png")}, {"--output", "is a directory"});
    refused({"-o", folder.file("a.png"), "--json", folder.folder()}, {"--json", "is a directory"});
    EXPECT_EQ(folder.names(), Words{"dir.png"});
}

TEST(Render, PicturesLargerThanMemoryAreRefused) {
    std::ifstream meminfo("/proc/meminfo");
    std::string word;
    double kilobytes = 0;
    if (!(meminfo >> word >> kilobytes) || kilobytes * 1024 > 50e9) GTEST_SKIP() << "too much memory, or not known";
    const TestFolder folder;
    expect_usage_error(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--size", "16384x16384"}),
                       {"--size", "16384x16384", "GB"});
}

TEST(Render, DoesNotOverwriteItsOwnScene) {
    const TestFolder folder;
    std::filesystem::copy_file(std::string(KD_SOURCE_DIR) + "/assets/scenes/lantern.gltf", folder.file("s.gltf"));
    const std::string before = read_file(folder.file("s.gltf"));
    expect_usage_error(
        run_kdscope({"render", folder.file("s.gltf"), "-o", folder.file("a.png"), "--csv", folder.file("s.gltf")}),
        {"--csv", "scene's own file"});
    EXPECT_EQ(read_file(folder.file("s.gltf")), before);
}

TEST(Render, StopLeavesNoFile) {
    const TestFolder folder;
    std::stop_source stop;
    stop.request_stop();
    const test::Outcome outcome =
        run_kdscope({"render", "ball:1000", "-o", folder.file("a.png"), "--size", "512x512"}, stop.get_token());
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err, "kdscope: interrupted\n");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Gallery, WritesAndNamesSixteenPictures) {
    const TestFolder folder;
    const test::Outcome outcome = run_kdscope({"gallery", "-o", folder.file("new/out"), "--size", "48x36"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream paths(outcome.out);
    int count = 0;
    for (std::string path; std::getline(paths, path); ++count) EXPECT_GT(read_png(path).width, 40) << path;
    EXPECT_EQ(count, 16);
}

TEST(Gallery, RefusesAFileAsFolder) {
    const TestFolder folder;
    std::ofstream(folder.file("taken")) << "x";
    expect_usage_error(run_kdscope({"gallery", "-o", folder.file("taken")}), {"--output", "taken"});
}

}  // namespace
}  // namespace kd
