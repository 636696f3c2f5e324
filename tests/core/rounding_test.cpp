// shaders/shared/rounding.glsl on a machine whose own quotients and roots are off by a few units in the last place.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/support/scenes.h"

namespace kd {
namespace {

int off_by = 0;  // units in the last place

struct Rough {
    float value;
    explicit Rough(double v) : value(float(v)) {}
};
Rough moved(float exact) {
    return Rough(std::bit_cast<float>(std::bit_cast<std::uint32_t>(exact) + std::uint32_t(off_by)));
}
Rough operator+(Rough a, Rough b) { return Rough(a.value + b.value); }
Rough operator-(Rough a, Rough b) { return Rough(a.value - b.value); }
Rough operator*(Rough a, Rough b) { return Rough(a.value * b.value); }
Rough operator/(Rough a, Rough b) { return moved(a.value / b.value); }
bool operator<(Rough a, Rough b) { return a.value < b.value; }
bool operator>(Rough a, Rough b) { return a.value > b.value; }
bool operator==(Rough a, Rough b) { return a.value == b.value; }
bool operator!=(Rough a, Rough b) { return a.value != b.value; }
Rough abs(Rough a) { return Rough(std::abs(a.value)); }
Rough sqrt(Rough a) { return moved(std::sqrt(a.value)); }

namespace rough {
using real = Rough;
const Rough KD_DEKKER(4097);
#undef KD_CORRECTED_ROUNDING
#define KD_CORRECTED_ROUNDING 1
#include "shaders/shared/rounding.glsl"
}  // namespace rough

/// Significand at random, sign either, exponent in [-low, low].
float number(test::Random& random, int low) {
    const float significand = random.uniform(1, 2);
    return std::ldexp(random.below(2) ? significand : -significand, random.below(2 * low + 1) - low);
}

TEST(Rounding, QuotientsAndRootsAreCorrectedToTheNearestNumber) {
    test::Random random(1);
    for (off_by = -3; off_by <= 3; ++off_by)
        for (int i = 0; i < 300000; ++i) {
            const float a = number(random, 30);
            float b = number(random, 30);
            // A divisor just below a power of two brings quotients closest to the middle between two numbers.
            if (i % 3 == 0) b = std::ldexp(std::nextafter(1.0f, 0.0f), random.below(61) - 30);
            ASSERT_EQ(rough::quotient(Rough(a), Rough(b)).value, a / b) << std::hexfloat << a << " / " << b;
            const float square = std::abs(a);
            ASSERT_EQ(rough::square_root(Rough(square)).value, std::sqrt(square)) << std::hexfloat << square;
        }
}

// A shadow ray of triangles 2^-20 wide divides 2^-81 by 2^-41 (T38): remainders underflow unless both are lifted.
TEST(Rounding, QuotientsAndRootsOfSmallNumbersAreCorrectedToo) {
    test::Random random(2);
    for (off_by = -3; off_by <= 3; ++off_by)
        for (int i = 0; i < 300000; ++i) {
            const float a = std::ldexp(number(random, 23), -102);  // 2^-125 to 2^-79
            const float b = std::ldexp(number(random, 10), random.below(60) - 70);
            const float exact = a / b;
            if (std::abs(exact) < 2e-30f || std::abs(exact) > 1e29f || std::abs(b) * 0x1p48f < 2e-30f) continue;
            ASSERT_EQ(rough::quotient(Rough(a), Rough(b)).value, exact) << std::hexfloat << a << " / " << b;
            const float square = std::abs(a);
            ASSERT_EQ(rough::square_root(Rough(square)).value, std::sqrt(square)) << std::hexfloat << square;
        }
}

TEST(Rounding, WhereNothingCanBeCorrectedTheMachinesAnswerStays) {
    off_by = 0;
    const float inf = std::numeric_limits<float>::infinity();
    for (const float a : {0.0f, -0.0f, 1e-38f, 3e38f, inf, 1.0f})
        for (const float b : {0.0f, -0.0f, 1e-38f, 3e38f, inf, 3.0f}) {
            const float expected = a / b, found = rough::quotient(Rough(a), Rough(b)).value;
            EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << a << " / " << b;
        }
    EXPECT_EQ(rough::square_root(Rough(0)).value, 0.0f);
}

}  // namespace
}  // namespace kd
