// Sampled light on the command line: what is gathered, told and refused.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::expect_usage_error, test::run_kdscope, test::TestFolder;
using Words = std::vector<std::string>;

struct Rendered {
    test::Outcome outcome;
    nlohmann::json json;
    Image<Rgba8> image;
};

/// `cornell`, small, by 4 samples and the further options.
Rendered rendered(const TestFolder& folder, const Words& options) {
    Words words{"render", "cornell", "--samples", "4", "--size", "32x32"};
    words.insert(words.end(), {"-o", folder.file("out.png"), "--json", folder.file("out.json")});
    words.insert(words.end(), options.begin(), options.end());
    Rendered made{run_kdscope(words), {}, {}};
    EXPECT_EQ(made.outcome.code, 0) << made.outcome.err;
    made.json = nlohmann::json::parse(read_file(folder.file("out.json")));
    made.image = read_png(folder.file("out.png"));
    return made;
}

TEST(SampledLightOption, CountsItsSamplesAndAllKindsOfRays) {
    const TestFolder folder;
    const Rendered made = rendered(folder, {});
    EXPECT_EQ(made.json["samples"]["most"], 4);
    EXPECT_GT(made.json["samples"]["standard_error"], 0.0);
    EXPECT_EQ(made.json["counters"]["primary"]["rays"], 4 * 32 * 32) << "sums over samples";
    for (const char* rays : {"shadow", "reflection", "reflection_shadow", "indirect", "indirect_shadow"})
        EXPECT_GT(made.json["counters"][rays]["rays"], 0) << rays;
    EXPECT_NE(made.outcome.out.find("samples   4 per pixel, standard error"), std::string::npos) << made.outcome.out;
}

TEST(SampledLightOption, SaysWhatBecameOfTheErrorAskedFor) {
    const TestFolder folder;
    EXPECT_NE(
        rendered(folder, {"--sample-error", "0.5"}).outcome.out.find("0 of 1 tiles converged to 0.5, which takes 16"),
        std::string::npos);
    const test::Outcome done = run_kdscope({"render", "cornell", "--samples", "64", "--sample-error", "1", "--size",
                                            "32x32", "-o", folder.file("done.png")});
    EXPECT_NE(done.out.find("16 at most, 16.0 on average per pixel"), std::string::npos) << done.out;
    EXPECT_NE(done.out.find("1 of 1 tiles converged to 1"), std::string::npos) << done.out;
}

TEST(SampledLightOption, EachEffectIsSwitchedOffByItself) {
    const TestFolder folder;
    std::vector<Image<Rgba8>> pictures{rendered(folder, {}).image};
    for (const char* without : {"--no-soft-shadows", "--no-gloss", "--no-indirect"})
        pictures.push_back(rendered(folder, {without}).image);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i].pixels, pictures[j].pixels) << i << " and " << j;
}

TEST(SampledLightOption, IsRefusedWithoutSamples) {
    const TestFolder folder;
    for (const char* option : {"--no-soft-shadows", "--no-gloss", "--no-indirect"})
        expect_usage_error(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), option}),
                           {option, "add --samples N"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--sample-error", "0.1"}),
                       {"--sample-error", "add --samples N"});
    expect_usage_error(run_kdscope({"render", "cornell", "-o", folder.file("a.png"), "--samples", "-5"}),
                       {"--samples"});
    EXPECT_TRUE(folder.names().empty()) << "nothing is written";
}

TEST(SampledLightOption, FiguresTellThatMapsAreSums) {
    const TestFolder folder;
    const Words map{"--map", "nodes"};
    (void)rendered(folder, map);
    const PngText text = read_png_text(folder.file("out.png"));
    EXPECT_NE(text.at("Title").find("sums over 4 samples"), std::string::npos) << text.at("Title");
    EXPECT_NE(text.at("Description").find("light by 4 samples"), std::string::npos) << text.at("Description");
}

}  // namespace
}  // namespace kd
