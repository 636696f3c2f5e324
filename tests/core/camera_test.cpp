// Cameras: the vectors rays are made from, the fitted camera, and what is refused.

#include "renderer/scene/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/geometry/input_error.h"
#include "renderer/scene/random.h"

namespace kd {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

double slope(float fov_degrees) { return std::tan(0.5 * glm::radians(double(fov_degrees))); }

/// Where a point is seen: x and y are -1..1 inside the image, z is the distance along the view.
glm::dvec3 project(const PinholeCamera& view, glm::dvec3 point) {
    const glm::dvec3 offset = point - glm::dvec3(view.eye);
    const auto along = [&](Vec3 axis) {
        return glm::dot(offset, glm::dvec3(axis)) / glm::dot(glm::dvec3(axis), glm::dvec3(axis));
    };
    const double depth = along(view.forward);
    return {along(view.right) / depth, along(view.up) / depth, depth};
}

TEST(Pinhole, LooksDownMinusZ) {
    const PinholeCamera view = pinhole({.eye = {0, 0, 3}, .target = {0, 0, 0}, .fov_y_degrees = 90.0f}, 200, 100);
    EXPECT_EQ(view.eye, Vec3(0, 0, 3));
    EXPECT_EQ(view.forward, Vec3(0, 0, -1));
    EXPECT_EQ(view.right, Vec3(2, 0, 0));  // twice as wide as high
    EXPECT_EQ(view.up, Vec3(0, 1, 0));
}

TEST(Pinhole, CameraLookingAlongXSeesZToTheRight) {
    const PinholeCamera view = pinhole({.eye = {0, 0, 0}, .target = {5, 0, 0}, .fov_y_degrees = 90.0f}, 1, 1);
    EXPECT_EQ(view.forward, Vec3(1, 0, 0));
    EXPECT_EQ(view.right, Vec3(0, 0, 1));
    EXPECT_EQ(view.up, Vec3(0, 1, 0));
}

TEST(Pinhole, AxesAreOrthogonalAndAsLongAsTheAngleSays) {
    Random random(3);
    const auto point = [&] { return Vec3(random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)); };
    for (int i = 0; i < 1000; ++i) {
        const Camera camera{point(), point(), point(), float(random.between(1, 170))};
        const PinholeCamera view = pinhole(camera, 300, 200);
        const double half_height = slope(camera.fov_y_degrees);
        EXPECT_NEAR(glm::length(view.forward), 1.0, 1e-6);
        EXPECT_NEAR(glm::length(view.up) / half_height, 1.0, 1e-6);
        EXPECT_NEAR(glm::length(view.right) / (1.5 * half_height), 1.0, 1e-6);
        EXPECT_NEAR(glm::dot(view.forward, glm::normalize(view.up)), 0.0, 1e-6);
        EXPECT_NEAR(glm::dot(view.forward, glm::normalize(view.right)), 0.0, 1e-6);
        EXPECT_GT(glm::dot(view.up, camera.up), 0.0f);
        EXPECT_GT(glm::dot(glm::cross(view.right, view.up), -view.forward), 0.0f) << "right-handed";
    }
}

TEST(Pinhole, TargetIsTheCentreOfTheImage) {
    const Camera camera{.eye = {1, 2, 3}, .target = {-4, 0.5f, 1}};
    const glm::dvec3 seen = project(pinhole(camera, 640, 480), glm::dvec3(camera.target));
    EXPECT_NEAR(seen.x, 0.0, 1e-6);
    EXPECT_NEAR(seen.y, 0.0, 1e-6);
}

TEST(Pinhole, ReplacesAnUpThatIsZeroOrAlongTheView) {
    const Camera down{.eye = {0, 5, 0}, .target = {0, 0, 0}, .fov_y_degrees = 90.0f};
    EXPECT_EQ(pinhole(down, 1, 1).up, Vec3(0, 0, -1));
    EXPECT_EQ(pinhole(down, 1, 1).right, Vec3(1, 0, 0));
    const Camera above{.eye = {0, 0, 0}, .target = {0, 5, 0}, .fov_y_degrees = 90.0f};
    EXPECT_EQ(pinhole(above, 1, 1).up, Vec3(0, 0, 1));
    const Camera z_up{.eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 0, -7}, .fov_y_degrees = 90.0f};
    EXPECT_EQ(pinhole(z_up, 1, 1).up, Vec3(0, 1, 0));
    const Camera no_up{.eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 0, 0}, .fov_y_degrees = 90.0f};
    EXPECT_EQ(pinhole(no_up, 1, 1).up, Vec3(0, 1, 0));
}

TEST(Pinhole, LengthOfUpDoesNotMatter) {
    const PinholeCamera usual = pinhole({.eye = {1, 2, 3}, .up = {0, 1, 0}}, 4, 3);
    for (const float length : {1e-30f, 1e30f}) {
        const PinholeCamera other = pinhole({.eye = {1, 2, 3}, .up = {0, length, 0}}, 4, 3);
        EXPECT_LT(glm::distance(usual.up, other.up), 1e-6f);
        EXPECT_LT(glm::distance(usual.right, other.right), 1e-6f);
    }
}

TEST(Pinhole, RefusesWhatIsNoCamera) {
    EXPECT_THROW((void)pinhole({.eye = {1, 1, 1}, .target = {1, 1, 1}}, 4, 4), InputError);
    EXPECT_THROW((void)pinhole(Camera{}, 0, 4), InputError);
    EXPECT_THROW((void)pinhole(Camera{}, 4, -1), InputError);
}

TEST(CameraValidity, NeedsFiniteDistinctPointsAndAnAngle) {
    EXPECT_TRUE(is_valid(Camera{}));
    EXPECT_TRUE(is_valid({.fov_y_degrees = 179.9f}));
    EXPECT_TRUE(is_valid({.fov_y_degrees = 1e-3f}));
    for (const float angle : {0.0f, -45.0f, 180.0f, nan, infinity})
        EXPECT_FALSE(is_valid({.fov_y_degrees = angle})) << angle;
    for (const float bad : {nan, infinity, -infinity}) {
        EXPECT_FALSE(is_valid({.eye = {0, bad, 3}}));
        EXPECT_FALSE(is_valid({.target = {bad, 0, 0}}));
        EXPECT_FALSE(is_valid({.up = {0, 1, bad}}));
    }
    EXPECT_FALSE(is_valid({.eye = {2, 2, 2}, .target = {2, 2, 2}}));
}

void expect_whole_box_seen(const Aabb& box) {
    const Camera camera = fit_camera(box);
    ASSERT_TRUE(is_valid(camera));
    const PinholeCamera view = pinhole(camera, 512, 512);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                               corner & 4 ? box.upper.z : box.lower.z);
        const glm::dvec3 seen = project(view, point);
        EXPECT_LE(std::abs(seen.x), 1.0001);
        EXPECT_LE(std::abs(seen.y), 1.0001);
        EXPECT_GT(seen.z, 0.0);
    }
}

TEST(FitCamera, SeesTheWholeBox) {
    expect_whole_box_seen({{-1, -1, -1}, {1, 1, 1}});
    expect_whole_box_seen({{0, 0, 0}, {100, 1, 0}});
    expect_whole_box_seen({{-1e-12f, 0, 0}, {1e-12f, 1e-12f, 3e-12f}});
    expect_whole_box_seen({{-1e17f, -1e17f, -1e17f}, {1e17f, 1e17f, 1e17f}});
    expect_whole_box_seen({{1e6f, 1e6f, 1e6f}, {1e6f + 1, 1e6f + 2, 1e6f + 1}});
}

TEST(FitCamera, LooksFromTheRightAboveAndInFront) {
    const Camera camera = fit_camera({{1, 1, 1}, {3, 3, 3}});
    EXPECT_EQ(camera.target, Vec3(2, 2, 2));
    const Vec3 offset = camera.eye - camera.target;
    EXPECT_NEAR(offset.y / offset.x, 0.7f, 1e-5f);
    EXPECT_NEAR(offset.z / offset.x, 1.4f, 1e-5f);
}

TEST(FitCamera, CopesWithNothingAPointAndTheLargestScenes) {
    EXPECT_EQ(fit_camera(Aabb{}), Camera{});
    EXPECT_TRUE(is_valid(fit_camera({{0, 0, 0}, {0, 0, 0}})));
    EXPECT_TRUE(is_valid(fit_camera({{1e9f, 5, 5}, {1e9f, 5, 5}})));
    const float limit = KD_COORDINATE_LIMIT;
    const Camera largest = fit_camera({Vec3(-limit), Vec3(limit)});
    ASSERT_TRUE(is_valid(largest));
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(largest.eye[axis]), limit) << "rays could not start there";
}

}  // namespace
}  // namespace kd
