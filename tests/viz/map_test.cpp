#include "viz/map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <set>

#include "renderer/geometry/input_error.h"
#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"
#include "viz/heatmap.h"

namespace kd {
namespace {

std::string error_of(const MapConfig& config) {
    try {
        static_cast<void>(compute_map(test::ball_frame(), config));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

float value_at(const std::string& name, int x, int y, Pass rays = Pass::rt_prim) {
    MapConfig config;
    config.map = name;
    config.rays = rays;
    return compute_map(test::ball_frame(), config).values.at(x, y);
}

TEST(Map, RegistryIsComplete) {
    std::set<std::string_view> names;
    for (const MapInfo& map : maps()) {
        EXPECT_TRUE(names.insert(map.name).second) << map.name;
        const bool of_groups = map.of_frame != nullptr || map.of_walks != nullptr;
        EXPECT_EQ((map.of_pixel != nullptr) + of_groups + (map.of_judged != nullptr), 1)
            << map.name << " needs exactly one function";
        EXPECT_TRUE(map.of_frame == nullptr || map.of_walks != nullptr) << map.name << " knows one schedule only";
        EXPECT_FALSE(map.title.empty()) << map.name;
        EXPECT_FALSE(map.summary.empty()) << map.name;
    }
    for (const char* name :
         {"nodes",      "first-visits", "revisits",    "revisit-share", "leaves",     "triangles",
          "restarts",   "backtracks",   "stack-depth", "exit",          "t",          "divergence",
          "idle",       "coherence",    "step-nodes",  "step-sectors",  "step-lines", "hit-triangles",
          "hit-leaves", "overhead",     "entry-depth", "steps-saved",   "oracle",     "t-error"}) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
}

TEST(Map, PixelMapsReadTheirCounter) {
    const int x = 30, y = 20;  // on the ball
    const RayCounters c = test::counters_at(x, y, true);
    ASSERT_GT(c.interior_again, 0u);
    EXPECT_EQ(value_at("nodes", x, y), float(c.interior_first + c.interior_again));
    EXPECT_EQ(value_at("first-visits", x, y), float(c.interior_first));
    EXPECT_EQ(value_at("revisits", x, y), float(c.interior_again));
    EXPECT_EQ(value_at("revisit-share", x, y), float(c.interior_again) / float(c.interior_first + c.interior_again));
    EXPECT_EQ(value_at("leaves", x, y), float(c.leaves));
    EXPECT_EQ(value_at("triangles", x, y), float(c.triangle_tests));
    EXPECT_EQ(value_at("steps", x, y), float(c.interior_first + c.interior_again + c.leaves + c.triangle_tests));
    EXPECT_EQ(value_at("restarts", x, y), float(c.restarts));
    EXPECT_EQ(value_at("backtracks", x, y), float(c.backtracks));
    EXPECT_EQ(value_at("stack-depth", x, y), float(c.stack_depth));
    EXPECT_EQ(value_at("exit", x, y), float(KD_EXIT_HIT));
    EXPECT_EQ(value_at("t", x, y), test::ball_frame().layer(Pass::rt_prim).hit.at(x, y).t);
}

TEST(Map, PixelsWithoutARayHaveNoValue) {
    for (const MapInfo& map : maps()) {
        if (map.name == "divergence") continue;  // a value of tiles
        EXPECT_TRUE(std::isnan(value_at(std::string(map.name), test::untraced_from, 20))) << map.name;
    }
    // Shadow rays start from hits only.
    EXPECT_TRUE(std::isnan(value_at("nodes", 1, 1, Pass::shade_prim)));
    EXPECT_EQ(value_at("nodes", 30, 20, Pass::shade_prim), 30.0f);
    EXPECT_TRUE(std::isnan(value_at("nodes", 30, 20, Pass::rt_refl)));
}

TEST(Map, PrimaryRayPastTheTreeCountsNothingButHasAValue) {
    EXPECT_EQ(value_at("nodes", 0, 0), 0.0f);
    EXPECT_EQ(value_at("exit", 0, 0), 0.0f);
    EXPECT_TRUE(std::isnan(value_at("revisit-share", 0, 0))) << "no visit, no share";
    EXPECT_TRUE(std::isnan(value_at("t", 0, 0))) << "no hit, no distance";
}

TEST(Map, OneCounterIsEnoughToCountAsTraced) {
    Frame frame(2, 1);
    EXPECT_FALSE(ray_traced(frame, Pass::shade_prim, 0));
    frame.layer(Pass::shade_prim).counters.at(0, 0).exit_reason = KD_EXIT_HIT;
    EXPECT_TRUE(ray_traced(frame, Pass::shade_prim, 0));
    frame.layer(Pass::rt_refl).hit.at(1, 0).triangle = 0;
    EXPECT_TRUE(ray_traced(frame, Pass::rt_refl, 1)) << "a hit on triangle 0 is a hit";
    EXPECT_FALSE(ray_traced(frame, Pass::rt_prim, 1)) << "alpha decides for primary rays";
}

TEST(Map, BrokenDistanceIsInfiniteNotMissing) {
    Frame frame(1, 1);
    frame.colour.at(0, 0).w = 1;
    frame.layer(Pass::rt_prim).hit.at(0, 0) = {5, std::nanf(""), 0, 0};
    MapConfig config;
    config.map = "t";
    EXPECT_TRUE(std::isinf(compute_map(frame, config).values.at(0, 0)));
}

TEST(Map, TitlesTellQuantityAndRays) {
    MapConfig config;
    config.rays = Pass::shade_refl;
    const ScalarMap map = compute_map(test::ball_frame(), config);
    EXPECT_EQ(map.title, "interior nodes visited");
    EXPECT_EQ(map.subject, "reflection shadow rays");
    EXPECT_EQ(map.unit, "visits");
    EXPECT_TRUE(map.integer);
    EXPECT_FALSE(map.natural_range.has_value());
}

TEST(Map, SharesHaveANaturalRangeAndExitHasCategories) {
    MapConfig config;
    config.map = "revisit-share";
    EXPECT_EQ(compute_map(test::ball_frame(), config).natural_range, (ValueRange{0, 1}));
    config.map = "exit";
    EXPECT_EQ(compute_map(test::ball_frame(), config).categories,
              (std::vector<std::string>{"miss", "hit", "step cap", "stack overflow", "invalid ray"}));
}

TEST(Map, UnknownNameListsTheKnownOnes) {
    MapConfig config;
    config.map = "heat";
    const std::string text = error_of(config);
    EXPECT_EQ(text.find("map 'heat': not known; choose one of nodes"), 0u) << text;
    EXPECT_NE(text.find("divergence"), std::string::npos) << text;
}

TEST(Map, TilesHold4To1024Pixels) {
    for (const auto& [w, h] : {std::pair{1, 1}, {3, 1}, {32, 33}, {0, 8}, {-8, -8}, {65536, 65536}, {8, 0}}) {
        MapConfig config{"divergence", Pass::rt_prim, w, h};
        EXPECT_NE(error_of(config).find("a tile holds 4 to 1024 pixels; try 8x4"), std::string::npos) << w << "x" << h;
        config.map = "nodes";  // does not look at tiles
        EXPECT_EQ(error_of(config), "");
    }
    for (const auto& [w, h] : {std::pair{4, 1}, {2, 2}, {32, 32}, {1024, 1}, {1, 1024}}) {
        EXPECT_EQ(error_of({"idle", Pass::rt_prim, w, h}), "") << w << "x" << h;
    }
}

// Counters are integers, and a quotient of two is rounded alike everywhere: every byte must be the same. Only a
// distance is the result of longer calculations.
TEST(MapGolden, EveryMap) {
    for (const MapInfo& info : maps()) {
        const MapConfig config{.map = std::string(info.name)};
        const JudgedLayer judged = test::ball_judged();
        const LockstepLayer walks = test::ball_walks();
        const ScalarMap map = compute_map(test::ball_frame(), config, {&judged, &walks});
        const HeatmapConfig heat;
        const bool exact = info.kind != MapInfo::Kind::length;
        test::expect_golden(paint_map(map, heat, choose_range(map, heat)), "map_" + config.map,
                            exact ? test::Tolerance{} : test::Tolerance{1, 0.001});
    }
}

TEST(MapGolden, MapsOfOtherTiles) {
    for (const auto& [w, h] : {std::pair{4, 2}, {32, 1}})
        for (const char* name : {"divergence", "idle"}) {
            const ScalarMap map = compute_map(test::ball_frame(), {name, Pass::rt_prim, w, h});
            test::expect_golden(paint_map(map, {}, choose_range(map, {})), fmt::format("map_{}_{}x{}", name, w, h));
        }
}

TEST(Map, EachIsExplainedInTheManual) {
    std::ifstream file(std::string(KD_SOURCE_DIR) + "/docs/maps.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    for (const MapInfo& map : maps()) {
        EXPECT_NE(manual.find("\n**" + std::string(map.name) + "**: "), std::string::npos)
            << "docs/maps.md lacks a paragraph on " << map.name;
    }
}

TEST(Map, SummariesAreShortSentences) {
    for (const MapInfo& map : maps()) {
        EXPECT_LE(map.summary.size(), 120u) << map.name << ": too long for a tooltip";
        EXPECT_TRUE(map.summary.ends_with('.')) << map.name;
        EXPECT_EQ(map.unit.empty(), map.kind == MapInfo::Kind::ratio || map.kind == MapInfo::Kind::category)
            << map.name << ": quantities have a unit, shares and names have none";
    }
}

}  // namespace
}  // namespace kd
