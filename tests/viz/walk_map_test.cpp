// The maps of groups' walks. What the walks are is tested in tests/core/lockstep_test.cpp and
// tests/gl/frame_walks_gl_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/geometry/input_error.h"
#include "tests/viz/synthetic.h"
#include "viz/figure.h"

namespace kd {
namespace {

ScalarMap map_of(const std::string& name, const LockstepLayer* walks) {
    const Schedule schedule = walks ? walks->schedule : Schedule::while_while;
    return compute_map(test::ball_frame(), {.map = name, .schedule = schedule}, {nullptr, walks});
}

std::string fact(const ScalarMap& map, const std::string& label) {
    for (const MapFact& fact : map.facts)
        if (fact.label == label) return fact.value;
    return "no such fact";
}

TEST(WalkMap, ShowsTheNumbersOfItsGroup) {
    const LockstepLayer walks = test::ball_walks(Schedule::while_while);
    // The group in column 2 and row 3.
    const auto value = [&](const char* name) { return map_of(name, &walks).values.at(17, 14); };
    EXPECT_EQ(value("divergence"), 23.0f / 48.0f);
    EXPECT_EQ(value("idle"), 48.0f - (10 + 1 + 14));
    EXPECT_EQ(value("step-nodes"), 3.3f);
    EXPECT_EQ(value("step-sectors"), 2.7f);
    EXPECT_EQ(value("step-lines"), 2.1f);
    EXPECT_EQ(value("coherence"), float((140.0 - 33.0) / (140 - 10)));
    EXPECT_EQ(value("hit-triangles"), 6.0f);
    EXPECT_EQ(value("hit-leaves"), 3.0f);
    EXPECT_EQ(value("overhead"), 1 + float(17 * 14 % 50) / 25);
    EXPECT_EQ(value("entry-depth"), 3.0f);
    EXPECT_EQ(value("steps-saved"), 5.0f);
}

TEST(WalkMap, PixelsWithoutARayHaveNoneOfTheirOwn) {
    const LockstepLayer walks = test::ball_walks(Schedule::if_if);
    EXPECT_TRUE(std::isnan(map_of("idle", &walks).values.at(61, 5)));
    for (const char* name : {"overhead", "entry-depth", "steps-saved"})
        EXPECT_TRUE(std::isnan(map_of(name, &walks).values.at(61, 5))) << name;
    EXPECT_FALSE(std::isnan(map_of("divergence", &walks).values.at(61, 5))) << "the group has rays";
    LockstepLayer none = test::ball_walks(Schedule::if_if);
    none.group_at(0, 0) = {};
    for (const char* name : {"divergence", "coherence", "step-nodes", "hit-triangles", "hit-leaves"})
        EXPECT_TRUE(std::isnan(map_of(name, &none).values.at(0, 0))) << name;
}

TEST(WalkMap, OtherHitsThanWithAStackAreBroken) {
    const LockstepLayer walks = test::ball_walks();
    const ScalarMap map = map_of("overhead", &walks);
    EXPECT_TRUE(std::isinf(map.values.at(3, 40)));
    EXPECT_EQ(fact(map, "other hits"), "1");
    EXPECT_EQ(fact(map, "whole image"), "2.500");
}

TEST(WalkMap, TellsWhereWalksBegin) {
    const LockstepLayer walks = test::ball_walks();
    for (const char* name : {"entry-depth", "steps-saved"}) {
        EXPECT_EQ(fact(map_of(name, &walks), "walks begin at"), "8×8 px tiles") << name;
        EXPECT_EQ(fact(map_of(name, &walks), "steps saved"), "25.0 %") << name;
    }
}

TEST(WalkMap, TellsScheduleAndShape) {
    const LockstepLayer walks = test::ball_walks(Schedule::if_if);
    for (const char* name : {"divergence", "idle", "coherence", "hit-triangles"}) {
        EXPECT_EQ(fact(map_of(name, &walks), "schedule"), "if-if") << name;
        EXPECT_EQ(fact(map_of(name, &walks), "tile"), "8×4 = 32 lanes") << name;
    }
    EXPECT_EQ(fact(map_of("divergence", &walks), "whole image"), fmt::format("{:.3f}", walks.efficiency().weighted));
}

TEST(WalkMap, CountersSufficeForTheIdealisedSchedule) {
    EXPECT_FALSE(needs_walks(MapConfig{.map = "divergence"}));
    EXPECT_TRUE(needs_walks(MapConfig{.map = "divergence", .schedule = Schedule::if_if}));
    EXPECT_TRUE(needs_walks(MapConfig{.map = "idle", .schedule = Schedule::while_while}));
    EXPECT_TRUE(needs_walks(MapConfig{.map = "coherence"}));
    EXPECT_FALSE(needs_walks(MapConfig{.map = "nodes", .schedule = Schedule::if_if}));
    EXPECT_FALSE(needs_walks(MapConfig{.map = "no such map"}));
    ViewConfig view;
    view.map.map = "coherence";
    EXPECT_TRUE(needs_walks(view));
    view.show_map = false;
    EXPECT_FALSE(needs_walks(view));
}

TEST(WalkMap, NothingWalkedHasNoValues) {
    for (const char* name : {"divergence", "idle", "coherence", "overhead"})
        for (const float value : map_of(name, nullptr).values.pixels) ASSERT_TRUE(std::isnan(value)) << name;
}

TEST(WalkMap, FitsWhatItWasMadeFor) {
    const LockstepLayer walks = test::ball_walks(Schedule::if_if);
    const MapConfig right{.map = "coherence", .schedule = Schedule::if_if};
    EXPECT_TRUE(fits(walks, right));
    MapConfig wrong = right;
    wrong.schedule = Schedule::while_while;
    EXPECT_FALSE(fits(walks, wrong));
    wrong = right;
    wrong.tile_width = 4;
    EXPECT_FALSE(fits(walks, wrong));
    wrong = right;
    wrong.rays = Pass::rt_refl;
    EXPECT_FALSE(fits(walks, wrong));
}

TEST(WalkMap, RefusesTilesThatNoGroupHas) {
    for (const char* name : {"coherence", "overhead"})
        EXPECT_THROW((void)compute_map(test::ball_frame(), {name, Pass::rt_prim, 65536, 65536}), InputError);
}

}  // namespace
}  // namespace kd
