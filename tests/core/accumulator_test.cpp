// Frames of samples gathered into one picture.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/trace/accumulator.h"
#include "renderer/trace/counters.h"

namespace kd {
namespace {

constexpr int width = 70, height = 33;  // three tiles by two

/// Every pixel of this grey, with a ray that took `steps` at a leaf.
Frame grey(float value, uint leaves = 1) {
    Frame frame(width, height);
    for (Vec4& colour : frame.colour.pixels) colour = Vec4(value, value, value, 1.0f);
    for (RayCounters& c : frame.layer(Pass::rt_prim).counters.pixels) {
        c.leaves = leaves;
        c.stack_depth = leaves;
        c.rays = 1;
    }
    return frame;
}

TEST(Accumulator, HoldsMeansOfColoursAndSumsOfCounters) {
    Accumulator gathered(width, height);
    gathered.add(grey(0.25f, 2), gathered.tiles());
    gathered.add(grey(0.75f, 5), gathered.tiles());
    const Frame frame = gathered.frame();
    for (const Vec4& colour : frame.colour.pixels) ASSERT_EQ(colour, Vec4(0.5f, 0.5f, 0.5f, 1.0f));
    for (const RayCounters& c : frame.layer(Pass::rt_prim).counters.pixels) {
        ASSERT_EQ(c.leaves, 7u);
        ASSERT_EQ(c.stack_depth, 5u);
        ASSERT_EQ(c.rays, 2u);
    }
    EXPECT_EQ(gathered.samples(), 2);
    EXPECT_EQ(gathered.average_samples(), 2);
}

TEST(Accumulator, OneFrameIsThatFrame) {
    Accumulator gathered(width, height);
    const Frame frame = grey(0.3f);
    gathered.add(frame, gathered.tiles());
    EXPECT_TRUE(same_frame(gathered.frame(), frame));
    EXPECT_TRUE(std::isinf(gathered.error()));
}

TEST(Accumulator, ErrorIsTheStandardErrorOfTheMean) {
    Accumulator gathered(width, height);
    constexpr int n = 40;
    for (int i = 0; i < n; ++i) gathered.add(grey(i % 2 == 0 ? 0.4f : 0.6f), gathered.tiles());
    // A standard deviation of 0.1, n - 1 in the denominator of the variance.
    EXPECT_NEAR(gathered.error(), 0.1 / std::sqrt(double(n - 1)), 1e-8);
}

TEST(Accumulator, TilesThatHaveConvergedRest) {
    Accumulator gathered(width, height);
    const auto add = [&](int samples) {
        for (int i = 0; i < samples; ++i) {
            Frame frame = grey(0.5f);
            if (i % 2 == 0) frame.colour.at(0, 0) = Vec4(1.0f);  // the first tile is not certain
            gathered.add(frame, gathered.active(0.001));
        }
    };
    add(Accumulator::fewest_samples - 1);
    EXPECT_EQ(gathered.active(0.001).size(), gathered.tiles().size());
    add(1);
    ASSERT_EQ(gathered.active(0.001).size(), 1u);
    EXPECT_EQ(gathered.active(0.001).front(), (Tile{0, 0, 32, 32}));
    EXPECT_EQ(gathered.active(0).size(), gathered.tiles().size()) << "nothing rests where no error is asked for";
    add(4);
    EXPECT_EQ(gathered.samples(), Accumulator::fewest_samples + 4);
    EXPECT_DOUBLE_EQ(gathered.average_samples(), Accumulator::fewest_samples + 4 * 32.0 * 32 / (width * height));
}

TEST(Accumulator, HitsAreThoseOfTheFirstSample) {
    Accumulator gathered(width, height);
    EXPECT_EQ(gathered.frame().colour.at(0, 0).w, 0.0f) << "untraced";
    for (const int number : {3, 4}) {
        Frame frame = grey(0.5f);
        frame.sampling.sample = number;
        frame.layer(Pass::rt_prim).hit.at(5, 5).triangle = number;
        gathered.add(frame, gathered.tiles());
    }
    EXPECT_EQ(gathered.frame().sampling.sample, 3);
    EXPECT_EQ(gathered.frame().layer(Pass::rt_prim).hit.at(5, 5).triangle, 3);
}

}  // namespace
}  // namespace kd
