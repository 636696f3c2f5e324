// render --needs, --force and verify --needs on the command line.
#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/scene/needs.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using nlohmann::json;
using test::expect_usage_error;
using test::run_kdscope;
using test::TestFolder;
using Words = std::vector<std::string>;

json read_json(const std::string& path) { return json::parse(std::ifstream(path)); }

TEST(Needs, AreListedWithoutAPicture) {
    const test::Outcome outcome = run_kdscope({"render", "cornell", "--needs", "--rounds", "0", "--size", "16x12"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const FeatureInfo& feature : features())
        EXPECT_NE(outcome.out.find(feature.title), std::string::npos) << feature.title;
    EXPECT_NE(outcome.out.find("no textured material"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("GPU only"), std::string::npos) << "the CPU traces";
    EXPECT_EQ(outcome.out.find("rounds in turn"), std::string::npos) << "nothing was timed";
}

TEST(Needs, ThePictureSaysHowToListThemUnlessItDoes) {
    const TestFolder folder;
    const Words common{"render", "cornell", "--size", "8x8", "-o", folder.file("a.png")};
    Words listed = common;
    listed.insert(listed.end(), {"--needs", "--rounds", "0"});
    EXPECT_NE(run_kdscope(common).out.find("; --needs tells why\n"), std::string::npos);
    EXPECT_EQ(run_kdscope(listed).out.find("--needs tells why"), std::string::npos);
}

TEST(Needs, AreInTheSummary) {
    const TestFolder folder;
    const test::Outcome outcome = run_kdscope({"render", "cornell", "--needs", "--rounds", "3", "--size", "16x12",
                                               "--json", folder.file("a.json"), "--force", "textures"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json data = read_json(folder.file("a.json"));
    EXPECT_EQ(data["settings"]["forced"], json::array({"textures"}));
    ASSERT_EQ(data["needs"].size(), features().size());
    for (const json& row : data["needs"]) {
        const std::string name = row["feature"];
        // Counters are needed by the maps, but not by frames that are timed.
        const bool timed = (row["can_return"] == true && row["state"] != "GPU only") || name == "counters";
        EXPECT_EQ(!row["saved_ms"].is_null(), timed) << name;
        if (timed) {
            EXPECT_EQ(row["saved_ms"]["rounds"], 3) << name;
        }
        if (name == "textures") {
            EXPECT_EQ(row["state"], "put back");
        }
        if (name == "shadows") {
            EXPECT_EQ(row["state"], "needed");
        }
        if (name == "normals") {
            EXPECT_EQ(row["state"], "left out");
        }
        if (name == "leaf-copies") {
            EXPECT_GT(row["bytes"], 0);
        }
    }
}

TEST(Needs, ForcedPicturesAreTheSame) {
    const TestFolder folder;
    const Words common{"render", "cornell", "--size", "24x16", "-o"};
    Words without = common, with = common;
    without.push_back(folder.file("without.png"));
    with.insert(with.end(), {folder.file("with.png"), "--force", "textures,normals,leaf-copies"});
    ASSERT_EQ(run_kdscope(without).code, 0);
    ASSERT_EQ(run_kdscope(with).code, 0);
    EXPECT_EQ(read_png(folder.file("without.png")).pixels, read_png(folder.file("with.png")).pixels);
}

TEST(Needs, WhatCannotReturnIsNoted) {
    const TestFolder folder;
    const test::Outcome outcome = run_kdscope({"render", "cornell", "--size", "8x8", "-o", folder.file("a.png"),
                                               "--no-shadows", "--force", "shadows,material-numbers"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("--force shadows has no effect: switched off"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--force material-numbers has no effect: 6 materials"), std::string::npos);
}

TEST(Needs, BadWordsAreTold) {
    expect_usage_error(run_kdscope({"render", "cornell"}), {"--output is required"});
    expect_usage_error(run_kdscope({"render", "cornell", "--needs", "--force", "texture"}), {"did you mean textures?"});
    expect_usage_error(run_kdscope({"render", "cornell", "--needs", "--force", "textures,"}), {"unknown feature ''"});
    expect_usage_error(run_kdscope({"render", "cornell", "--needs", "--map", "nodes"}), {"no picture is written"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", "x.png", "--rounds", "3"}), {"only --needs times"});
    expect_usage_error(run_kdscope({"verify", "cornell", "--force", "textures"}), {"only --needs traces frames"});
    expect_usage_error(run_kdscope({"verify", "cornell", "--needs", "--adversarial", "3"}), {"not single rays"});
    expect_usage_error(run_kdscope({"verify", "cornell", "--needs", "--force", "textures"}),
                       {"puts features back itself"});
}

TEST(Needs, AreVerified) {
    const test::Outcome outcome =
        run_kdscope({"verify", "--needs", "cornell", "scatter:50", "--size", "24x16", "--tracer", "cpu", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json data = json::parse(outcome.out);
    ASSERT_EQ(data.size(), 2u);
    for (const json& scene : data) {
        EXPECT_TRUE(scene["passed"]);
        EXPECT_GE(scene["rows"].size(), 5u);
        for (const json& row : scene["rows"]) EXPECT_EQ(row["pixels"], 24 * 16);
    }
}

}  // namespace
}  // namespace kd
