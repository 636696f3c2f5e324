// The part of a triangle in a cell: against shapes worked out by hand, and that no point of it is left outside.

#include "renderer/kdtree/clip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.h"

namespace kd {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Clips to a cell of which nothing is known.
Aabb part_in(const Triangle& triangle, const Aabb& cell) {
    const Aabb whole = bounds_of(triangle);
    return clipped_bounds(triangle, cell, {glm::max(whole.lower, cell.lower), glm::min(whole.upper, cell.upper)});
}

/// `found` is at most two floats beyond `wanted`, away from the inside.
void expect_just_below(float found, float wanted) {
    EXPECT_LE(found, wanted);
    EXPECT_GE(found, std::nextafter(std::nextafter(wanted, -infinity), -infinity));
}

TEST(Clip, BoxOfThePartByHand) {
    // y = 4 - x from (0, 4) to (4, 0), and below: between x = 1 and x = 2 the part reaches up to y = 3.
    const Triangle triangle{{Vec3(0, 0, 7), Vec3(4, 0, 7), Vec3(0, 4, 7)}};
    const Aabb part = part_in(triangle, {Vec3(1, -9, 5), Vec3(2, 9, 9)});
    EXPECT_EQ(part.lower, Vec3(1, 0, 7));
    EXPECT_EQ(part.upper.x, 2.0f);
    EXPECT_EQ(part.upper.z, 7.0f) << "what lies across an axis goes on doing so";
    expect_just_below(-part.upper.y, -3.0f);
}

TEST(Clip, CornersInTheCellKeepTheirCoordinates) {
    const Triangle triangle{{Vec3(0.1f, 0.2f, 0.3f), Vec3(9, 0.7f, 0.4f), Vec3(0.6f, 9, 0.9f)}};
    const Aabb part = part_in(triangle, {Vec3(0), Vec3(1, 1, 1)});
    EXPECT_EQ(part.lower, Vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(part.upper.x, 1.0f);
    EXPECT_EQ(part.upper.y, 1.0f);
    EXPECT_LT(part.upper.z, 0.5f) << "the corner at z = 0.9 is far from the cell";
}

TEST(Clip, WhatIsKnownBoundsThePart) {
    const Triangle triangle{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 4)}};
    const Aabb cell{Vec3(0), Vec3(2)};
    const Aabb known{Vec3(0), Vec3(2, 0.5f, 2)};
    const Aabb part = clipped_bounds(triangle, cell, known);
    EXPECT_EQ(part.upper.y, 0.5f);
    const Aabb elsewhere{Vec3(3, 3, 3), Vec3(4, 4, 4)};
    EXPECT_EQ(clipped_bounds(triangle, elsewhere, elsewhere), elsewhere) << "nothing of it is there";
}

/// A cell somewhere in the box of a triangle.
Aabb cell_in(const Aabb& box, test::Random& random) {
    Aabb cell;
    for (int k = 0; k < 2; ++k) cell.include(box.lower + random.point(-0.1f, 1.1f) * box.extent());
    return cell;
}

TEST(Clip, HoldsEveryPointOfThePart) {
    test::Random random(31);
    int inside = 0;
    double tightness = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const float scale = std::ldexp(1.0f, 20 * (i % 11 - 5));
        const Vec3 away = i % 2 == 0 ? Vec3(0.0f) : scale * random.point(-1000, 1000);
        Triangle triangle;
        for (Vec3& corner : triangle.corner) corner = away + scale * random.point(-1, 1);
        if (i % 7 == 0) triangle.corner[1].x = triangle.corner[0].x;
        const Aabb cell = cell_in(bounds_of(triangle), random);
        const Aabb part = part_in(triangle, cell);
        Aabb seen;
        for (int k = 0; k < 200; ++k) {
            double u = double(random.uniform(0, 1)), v = double(random.uniform(0, 1));
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const glm::dvec3 a(triangle.corner[0]), b(triangle.corner[1]), c(triangle.corner[2]);
            const glm::dvec3 p = a + u * (b - a) + v * (c - a);
            if (glm::any(glm::lessThan(p, glm::dvec3(cell.lower))) ||
                glm::any(glm::greaterThan(p, glm::dvec3(cell.upper))))
                continue;
            ++inside;
            seen.include(Vec3(p));
            // The sample itself is rounded by a few parts in 2^53, to either side.
            const glm::dvec3 slack = 0x1p-50 * glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
            ASSERT_FALSE(glm::any(glm::lessThan(p, glm::dvec3(part.lower) - slack))) << i;
            ASSERT_FALSE(glm::any(glm::greaterThan(p, glm::dvec3(part.upper) + slack))) << i;
        }
        if (!seen.empty() && part.surface_area() > 0) tightness += seen.surface_area() / part.surface_area() > 0.5;
    }
    EXPECT_GT(inside, 20000) << "the test is about something";
    EXPECT_GT(tightness, 1000) << "boxes are not much larger than what lies in them";
}

/// Each bound of one box beside that of the other: rounding in double, outwards to floats, ends in neighbours.
void expect_neighbours(const Aabb& a, const Aabb& b) {
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& [x, y] : {std::pair(a.lower[axis], b.lower[axis]), std::pair(a.upper[axis], b.upper[axis])}) {
            EXPECT_GE(y, std::nextafter(x, -infinity));
            EXPECT_LE(y, std::nextafter(x, infinity));
        }
}

TEST(Clip, HalvesAreThePartsInBothHalvesOfTheCell) {
    test::Random random(32);
    for (int i = 0; i < 3000; ++i) {
        Triangle triangle;
        for (Vec3& corner : triangle.corner) corner = random.point(-1, 1);
        const Aabb cell = cell_in(bounds_of(triangle), random);
        const Aabb part = part_in(triangle, cell);
        const int axis = i % 3;
        const float position = 0.5f * (part.lower[axis] + part.upper[axis]);
        if (!(part.lower[axis] < position && position < part.upper[axis])) continue;
        const auto halves = clipped_halves(triangle, cell, axis, position, part);
        for (int side = 0; side < 2; ++side) {
            Aabb half = cell, known = part;
            (side == 0 ? half.upper : half.lower)[axis] = (side == 0 ? known.upper : known.lower)[axis] = position;
            expect_neighbours(halves[std::size_t(side)], clipped_bounds(triangle, half, known));
        }
    }
}

}  // namespace
}  // namespace kd
