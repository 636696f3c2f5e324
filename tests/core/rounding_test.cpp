// shaders/shared/rounding.glsl on a machine whose own quotients and roots are off by a few units in the last place, and
// the digits that triangle.glsl restores with it.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/scenes.h"

namespace kd {
namespace {

/// The triangle test's own text in single precision, of a scene that is not asked for.
struct TriangleText {
    void fetch_bounds(real3&, real3&) const {}
    static bool masked_out(int, real, real) { return false; }
    void fetch_corners(int, int, int3, real3&, real3&, real3&) const {}
#define KD_RULES KD_RULES_ROBUST
#include "shaders/shared/vector.glsl"
// After what it uses.
#include "shaders/shared/ray.glsl"
// After what it uses.
#include "shaders/shared/triangle.glsl"
#undef KD_RULES
};

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

// A float's product has at most 48 bits, so that double holds it.
TEST(Rounding, WhatAProductLosesIsExact) {
    test::Random random(3);
    for (int i = 0; i < 1'000'000; ++i) {
        const float a = number(random, 30), b = number(random, 30);
        const double product = double(a) * double(b);
        ASSERT_EQ(double(TriangleText().product_error(a, b)), product - double(float(product)))
            << std::hexfloat << a << " * " << b;
    }
}

/// p*q and r*s so close that few digits of their difference are left, if any.
struct CloseProducts {
    float p, q, r, s;

    explicit CloseProducts(test::Random& random) : p(number(random, 20)), q(number(random, 20)), r(number(random, 20)) {
        s = p * q / r;
        const int steps = random.below(7) - 3;
        for (int i = 0; i < std::abs(steps); ++i) s = std::nextafter(s, steps < 0 ? 0.0f : 2 * s);
    }
    /// Two numbers of at most 48 bits within a factor of two of each other: their difference is a double too.
    [[nodiscard]] double exact() const { return double(p) * double(q) - double(r) * double(s); }
    [[nodiscard]] float plain() const { return p * q - r * s; }
    [[nodiscard]] float restored() const { return TriangleText().with_lost_digits(plain(), p, q, r, s); }
};

int sign(double x) { return (x > 0) - (x < 0); }

// With products so close their rounded values differ by an exact number (Sterbenz). The two errors are multiples of
// 2^-24 ulp of the larger product and at most half an ulp each, so that their difference is a float, unless the
// products lie on both sides of a power of two: there it is rounded, by 2^-24 of what has the sign of the rest. So the
// sign is exact, and the value within that and its own rounding, together below an ulp.
TEST(Rounding, AnEdgeFunctionWithItsLostDigitsHasTheExactSign) {
    test::Random random(4);
    int plain_errs = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const CloseProducts c(random);
        const double exact = c.exact();
        const float restored = c.restored();
        plain_errs += sign(double(c.plain())) != sign(exact);
        const auto what = [&] {
            return testing::Message() << std::hexfloat << c.p << " * " << c.q << " - " << c.r << " * " << c.s;
        };
        ASSERT_EQ(sign(double(restored)), sign(exact)) << what();
        const float size = std::abs(float(exact));
        const double ulp = double(std::nextafter(size, std::numeric_limits<float>::infinity())) - double(size);
        ASSERT_LE(std::abs(double(restored) - exact), ulp) << what();
    }
    EXPECT_GT(plain_errs, 100'000) << "the plain expression is wrong often enough for this to be a test";
}

}  // namespace
}  // namespace kd
