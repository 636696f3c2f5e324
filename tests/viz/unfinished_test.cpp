// Pixels whose rays were given up are counted once, by their worst reason, and told.
#include "viz/unfinished.h"

#include <gtest/gtest.h>

namespace kd {
namespace {

uint& exit_at(Frame& frame, Pass pass, int x) { return frame.layer(pass).counters.at(x, 0).exit_reason; }

TEST(Unfinished, HitsAndMissesAreAnswers) {
    Frame frame(3, 1);
    exit_at(frame, Pass::rt_prim, 1) = KD_EXIT_HIT;
    EXPECT_EQ(count_unfinished(frame), UnfinishedPixels{});
    EXPECT_EQ(unfinished_text(count_unfinished(frame)), "");
    EXPECT_EQ(count_unfinished(Frame{}), UnfinishedPixels{});
}

TEST(Unfinished, OnePixelCountsOnceHoweverManyRaysItGaveUp) {
    Frame frame(4, 1);
    exit_at(frame, Pass::rt_prim, 2) = KD_EXIT_STEP_CAP;
    exit_at(frame, Pass::shade_prim, 2) = KD_EXIT_STEP_CAP;
    const UnfinishedPixels found = count_unfinished(frame);
    EXPECT_EQ(found.pixels, 1);
    EXPECT_EQ(found.rays, Pass::rt_prim);
    EXPECT_EQ(unfinished_text(found), "1 pixel unfinished: step cap");
}

TEST(Unfinished, SeveralReasonsAreCountedApartAndTheWorstPassNamed) {
    Frame frame(4, 1);
    exit_at(frame, Pass::rt_prim, 0) = KD_EXIT_STEP_CAP;
    exit_at(frame, Pass::shade_prim, 0) = KD_EXIT_INVALID_RAY;
    exit_at(frame, Pass::shade_prim, 1) = KD_EXIT_STEP_CAP;
    exit_at(frame, Pass::shade_prim, 3) = KD_EXIT_STEP_CAP;
    const UnfinishedPixels found = count_unfinished(frame);
    EXPECT_EQ(found.pixels, 3);
    EXPECT_EQ(found.by_reason[KD_EXIT_STEP_CAP], 2);
    EXPECT_EQ(found.by_reason[KD_EXIT_INVALID_RAY], 1);
    EXPECT_EQ(found.rays, Pass::shade_prim);
    EXPECT_EQ(unfinished_text(found), "3 pixels unfinished: 2 step cap, 1 invalid ray");
}

}  // namespace
}  // namespace kd
