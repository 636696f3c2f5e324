#include "renderer/trace/judged_layer.h"

#include <gtest/gtest.h>

namespace kd {
namespace {

/// One pixel of every verdict, `none` last.
JudgedLayer one_of_each() {
    JudgedLayer layer;
    layer.hits = Image<JudgedHit>(4, 2);
    for (std::size_t i = 0; i < 8; ++i) layer.hits.pixels[i] = {HitVerdict(i), double(i), {}};
    layer.tally();
    return layer;
}

TEST(JudgedLayer, CountsEveryVerdictButNone) {
    const JudgedLayer layer = one_of_each();
    EXPECT_EQ(layer.compared(), 7);
    EXPECT_EQ(layer.wrong(), 5);
    for (const std::int64_t count : layer.counts) EXPECT_EQ(count, 1);
    EXPECT_EQ(layer.worst_ulps, 0) << "of the pixel that agrees";
    EXPECT_EQ(JudgedLayer{}.compared(), 0);
}

TEST(JudgedLayer, EveryVerdictHasAName) {
    EXPECT_EQ(name_of(HitVerdict::agrees), "agrees");
    EXPECT_EQ(name_of(HitVerdict::wrong_t), "t off");
    EXPECT_EQ(name_of(HitVerdict::unfinished), "unfinished");
    EXPECT_EQ(name_of(HitVerdict::none), "not compared");
    EXPECT_FALSE(is_wrong(HitVerdict::agrees) || is_wrong(HitVerdict::tie) || is_wrong(HitVerdict::none));
}

}  // namespace
}  // namespace kd
