// The maps of the oracle's verdicts. What the verdicts say is tested in tests/gl/frame_judge_gl_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/geometry/input_error.h"
#include "tests/viz/synthetic.h"
#include "viz/figure.h"
#include "viz/numbers.h"

namespace kd {
namespace {

ScalarMap map_of(const std::string& name, const JudgedLayer* judged) {
    return compute_map(test::ball_frame(), {.map = name}, judged);
}

std::string fact(const ScalarMap& map, const std::string& label) {
    for (const MapFact& fact : map.facts)
        if (fact.label == label) return fact.value;
    return "no such fact";
}

TEST(OracleMap, ValuesAreTheVerdicts) {
    const JudgedLayer judged = test::ball_judged();
    const ScalarMap map = map_of("oracle", &judged);
    ASSERT_EQ(map.categories.size(), verdict_count);
    for (int verdict = 0; verdict < int(verdict_count); ++verdict)
        EXPECT_EQ(map.values.at(8 * verdict, 20), float(verdict)) << map.categories[std::size_t(verdict)];
    EXPECT_EQ(map.categories[2], "missed");
    EXPECT_TRUE(std::isnan(map.values.at(test::untraced_from, 20)));
}

TEST(OracleMap, TellsHowManyAreWrong) {
    JudgedLayer judged = test::ball_judged();
    EXPECT_EQ(fact(map_of("oracle", &judged), "wrong"), number_text(2112));
    EXPECT_EQ(fact(map_of("oracle", &judged), "compared"), number_text(2880));
    EXPECT_EQ(fact(map_of("t-error", &judged), "wrong"), number_text(2112));
    EXPECT_EQ(fact(map_of("oracle", &judged), "0 of n means"), "no such fact");
    for (JudgedHit& hit : judged.hits.pixels)
        if (hit.verdict != HitVerdict::none) hit.verdict = HitVerdict::agrees;
    judged.tally();
    EXPECT_EQ(fact(map_of("oracle", &judged), "wrong"), "0");
    EXPECT_EQ(fact(map_of("oracle", &judged), "0 of n means"), "< " + number_text(3.0 / 2880)) << "3/n";
}

TEST(OracleMap, ErrorOfTIsInfiniteWhereOneMissedAndNoneWhereBothDid) {
    const JudgedLayer judged = test::ball_judged();
    const ScalarMap map = map_of("t-error", &judged);
    EXPECT_TRUE(std::isnan(map.values.at(2, 2))) << "both missed";
    EXPECT_EQ(map.values.at(2, 20), 5.0f);
    EXPECT_TRUE(std::isinf(map.values.at(16, 20))) << "missed";
    EXPECT_TRUE(std::isinf(map.values.at(24, 20))) << "false hit";
    EXPECT_EQ(map.values.at(32, 20), 5.0f) << "of a wrong triangle, too";
    EXPECT_TRUE(std::isinf(map.values.at(48, 20))) << "unfinished";
    EXPECT_EQ(map.unit, "ulp");
    EXPECT_FALSE(map.integer);
}

TEST(OracleMap, NothingComparedHasNoValues) {
    for (const char* name : {"oracle", "t-error"}) {
        EXPECT_TRUE(needs_oracle(MapConfig{.map = name}));
        for (const float value : map_of(name, nullptr).values.pixels) ASSERT_TRUE(std::isnan(value));
    }
    EXPECT_FALSE(needs_oracle(MapConfig{.map = "exit"}));
    EXPECT_FALSE(needs_oracle(MapConfig{.map = "no such map"}));
}

TEST(OracleMap, OnlyAskedForWhereItIsShown) {
    ViewConfig view;
    view.map.map = "oracle";
    EXPECT_TRUE(needs_oracle(view));
    view.show_map = false;
    EXPECT_FALSE(needs_oracle(view));
}

TEST(OracleMap, ShadowRaysHaveNothingToCompare) {
    for (const Pass rays : {Pass::shade_prim, Pass::shade_refl}) {
        try {
            (void)compute_map(test::ball_frame(), {.map = "oracle", .rays = rays});
            ADD_FAILURE() << "accepted";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("choose primary or reflection rays"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace kd
