// What failures among samples say about all.

#include "renderer/trace/upper_bound.h"

#include <gtest/gtest.h>

namespace kd {
namespace {

TEST(UpperBound95, NoneSeenIsThreeOverN) {
    EXPECT_DOUBLE_EQ(upper_bound_95(0, 1000), 0.003);
    EXPECT_DOUBLE_EQ(upper_bound_95(0, 3'000'000), 1e-6);
    EXPECT_EQ(upper_bound_95(0, 2), 1.0) << "no share is above 1";
    EXPECT_EQ(upper_bound_95(0, 0), 1.0) << "nothing was asked";
}

TEST(UpperBound95, SomeSeenIsWilsons) {
    // (p + z²/2n + z sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n) with z = 1.6449, worked out by hand
    EXPECT_NEAR(upper_bound_95(1, 100), 0.04358, 5e-6);
    EXPECT_NEAR(upper_bound_95(50, 100), 0.58115, 5e-6);
    EXPECT_EQ(upper_bound_95(100, 100), 1.0);
    EXPECT_GT(upper_bound_95(1, 1'000'000), 1e-6);
    EXPECT_LT(upper_bound_95(1, 1'000'000), 6e-6);
}

}  // namespace
}  // namespace kd
