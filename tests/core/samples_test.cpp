// What light is sampled by (shaders/shared/samples.glsl, scatter.glsl), against what defines it.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "renderer/measure/double_kernel.h"
#include "renderer/scene/random.h"

namespace kd {
namespace {

/// The shared text in single precision, drawing sample `number`.
struct Samples {
    int number = 0;

    int sample_number() const { return number; }
#include "shaders/shared/vector.glsl"
// Uses it.
#include "shaders/shared/samples.glsl"
};

std::vector<Vec2> squares(uint key, int first, int count) {
    std::vector<Vec2> points;
    for (int i = first; i < first + count; ++i) points.push_back(Samples{i}.sample_square(key));
    return points;
}

TEST(Samples, EveryPowerOfTwoOfThemFillsEveryElementaryInterval) {
    constexpr int digits = 8, count = 1 << digits;
    for (const uint key : {0u, 1234567u, 0xfffffff0u})
        for (const int first : {0, count, 7 * count})
            for (int columns = 0; columns <= digits; ++columns) {
                std::vector<int> points_in(count, 0);
                for (const Vec2& p : squares(key, first, count)) {
                    const int column = int(p.x * float(1 << columns));
                    const int row = int(p.y * float(1 << (digits - columns)));
                    ++points_in[std::size_t((row << columns) + column)];
                }
                EXPECT_EQ(points_in, std::vector<int>(count, 1)) << key << " from " << first << ", " << columns;
            }
}

TEST(Samples, ThoseOfTwoKeysHaveNothingToDoWithEachOther) {
    // The mean of n products of independent numbers of 0..1 is 1/4, with a standard deviation of sqrt(7/144/n).
    constexpr int count = 4096;
    for (const uint key : {0u, 99u}) {
        const auto a = squares(key, 0, count), b = squares(key + 4, 0, count);
        double mean = 0;
        for (int i = 0; i < count; ++i) mean += double(a[std::size_t(i)].x) * double(b[std::size_t(i)].x) / count;
        EXPECT_NEAR(mean, 0.25, 4 * std::sqrt(7.0 / 144 / count)) << key;
    }
}

TEST(Samples, DiscsAreFilledInProportion) {
    constexpr int count = 4096;
    std::array<int, 4> rings{};
    for (const Vec2& p : squares(5, 0, count)) {
        const Vec2 disc = Samples{}.disc_of(p);
        const float squared = disc.x * disc.x + disc.y * disc.y;
        ASSERT_LE(squared, 1.0f + 4e-7f);
        ++rings[std::size_t(std::min(int(squared * 4), 3))];
    }
    for (const int ring : rings) EXPECT_NEAR(ring, count / 4, 24);  // worst measured: 12
}

TEST(Samples, TheSquaresEdgeIsTheCircle) {
    for (int i = 0; i <= 100; ++i)
        for (const Vec2& edge : {Vec2(0.0f, float(i) / 100), Vec2(float(i) / 100, 1.0f)}) {
            const glm::dvec2 disc(Samples{}.disc_of(edge));
            EXPECT_NEAR(glm::length(disc), 1.0, 2e-7) << edge.x << " " << edge.y;
        }
}

TEST(Samples, BasesAreOrthonormal) {
    Random random(3);
    std::vector<Vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-4f, 0, -1}};
    for (int i = 0; i < 1000; ++i) {
        const auto side = [&] { return float(2 * random.unit() - 1); };
        const Vec3 v(side(), side(), side());
        if (glm::length(v) > 0.1f) normals.push_back(v);
    }
    for (const Vec3& v : normals) {
        const Vec3 n = glm::normalize(v);
        Vec3 a, b;
        Samples{}.basis_of(n, a, b);
        for (const float zero : {glm::dot(a, b), glm::dot(a, n), glm::dot(b, n)}) EXPECT_NEAR(zero, 0.0f, 5e-7f);
        for (const float one : {glm::dot(a, a), glm::dot(b, b)}) EXPECT_NEAR(one, 1.0f, 1e-6f);
    }
}

/// Light that a rough mirror sends towards a viewer in a world that is white all over: by sampled facets.
double sampled_albedo(double cosine, double alpha) {
    constexpr int count = 4096;
    const FlatScene none;
    f64::DoubleKernel kernel(none);
    const glm::dvec3 viewer(std::sqrt(1 - cosine * cosine), 0, cosine);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const Vec2 square = Samples{i}.sample_square(17);
        const glm::dvec3 facet = kernel.visible_facet(viewer, alpha, kernel.disc_of(glm::dvec2(square)));
        const glm::dvec3 mirrored = 2 * glm::dot(viewer, facet) * facet - viewer;
        sum += kernel.unmasked(mirrored.z, alpha);
    }
    return sum / count;
}

/// The same by its definition, the integral of D G1 G1 / (4 cosine) over directions, on a grid.
double integrated_albedo(double cosine, double alpha) {
    constexpr int rings = 1500, steps = 400;
    const FlatScene none;
    f64::DoubleKernel kernel(none);
    const glm::dvec3 viewer(std::sqrt(1 - cosine * cosine), 0, cosine);
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < steps; ++j) {
            // Equal areas of the hemisphere; one half suffices.
            const double z = (i + 0.5) / rings, angle = (j + 0.5) / steps * std::numbers::pi;
            const double across = std::sqrt(1 - z * z);
            const glm::dvec3 light(across * std::cos(angle), across * std::sin(angle), z);
            const glm::dvec3 half = glm::normalize(viewer + light);
            const double a2 = alpha * alpha, slope = (a2 - 1) * half.z * half.z + 1;
            const double facets = a2 / (std::numbers::pi * slope * slope);
            sum += facets * kernel.unmasked(cosine, alpha) * kernel.unmasked(z, alpha) / (4 * cosine);
        }
    return sum * 2 * std::numbers::pi / (double(rings) * steps);
}

TEST(Samples, FacetsReflectWhatTheirDistributionDefines) {
    for (const double alpha : {0.2, 0.5, 1.0})
        for (const double cosine : {1.0, 0.6, 0.2})
            EXPECT_NEAR(sampled_albedo(cosine, alpha), integrated_albedo(cosine, alpha), 3e-3)
                << alpha << " seen at a cosine of " << cosine;
}

TEST(Samples, AMirrorIsTheLimitOfSmoothness) { EXPECT_NEAR(sampled_albedo(0.5, 1e-4), 1.0, 1e-6); }

}  // namespace
}  // namespace kd
