#include "viz/projection.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/viz/synthetic.h"

namespace kd {
namespace {

PinholeCamera camera_at(Vec3 eye, Vec3 target, int width, int height) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.fov_y_degrees = 90;
    return pinhole(camera, width, height);
}

TEST(Projection, KnownPoints) {
    // 90 degrees: the picture's upper edge is at height = distance. 200 x 100: its right edge at twice that.
    const Projection projection(camera_at({0, 0, 4}, {0, 0, 0}, 200, 100), 200, 100);
    const auto centre = projection.project({0, 0, 0});
    ASSERT_TRUE(centre);
    EXPECT_NEAR(centre->x, 100, 1e-4);
    EXPECT_NEAR(centre->y, 50, 1e-4);
    EXPECT_NEAR(centre->depth, 4, 1e-6);
    const auto corner = projection.project({8, 4, 0});
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->x, 200, 1e-3);
    EXPECT_NEAR(corner->y, 0, 1e-3);
    EXPECT_FALSE(projection.project({0, 0, 4})) << "the eye itself";
    EXPECT_FALSE(projection.project({0, 0, 9})) << "behind";
}

TEST(Projection, UndoesCameraRays) {
    const int w = 64, h = 48;
    const PinholeCamera camera = pinhole(test::ball_camera(), w, h);
    const Projection projection(camera, w, h);
    for (int y = 0; y < h; y += 5) {
        for (int x = 0; x < w; x += 5) {
            const double t = 1.5 + 0.1 * x;
            const glm::dvec3 point = glm::dvec3(camera.eye) + t * test::pixel_direction(camera, x, y, w, h);
            const auto p = projection.project(Vec3(point));
            ASSERT_TRUE(p);
            EXPECT_NEAR(p->x, x + 0.5, 1e-4);
            EXPECT_NEAR(p->y, y + 0.5, 1e-4);
            EXPECT_NEAR(p->depth, projection.depth_at(x, y, t), 1e-5);
        }
    }
}

TEST(Projection, SegmentsAreCutToTheNearPlaneAndThePicture) {
    const Projection projection(camera_at({0, 0, 4}, {0, 0, 0}, 100, 100), 100, 100);
    // From the middle of the picture to far behind the eye, on the right.
    const auto cut = projection.project_segment({0, 0, 0}, {3, 0, 12}, 0);
    ASSERT_TRUE(cut);
    EXPECT_NEAR(cut->a.x, 50, 1e-4);
    EXPECT_NEAR(cut->b.x, 100, 1e-6) << "leaves through the right edge";
    EXPECT_GT(cut->b.depth, 0);
    EXPECT_FALSE(projection.project_segment({0, 0, 5}, {1, 1, 9})) << "behind the eye";
    EXPECT_FALSE(projection.project_segment({50, 0, 0}, {50, 9, 0})) << "beside the picture";
    EXPECT_FALSE(projection.project_segment({0, 0, 4}, {0, 0, 4})) << "the eye itself";
}

TEST(Projection, RandomSegmentsStayNearThePicture) {
    const Projection projection(camera_at({1, 2, 3}, {0, 0, 0}, 80, 60), 80, 60);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> at(-6, 6);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a(at(random), at(random), at(random));
        const Vec3 b(at(random), at(random), at(random));
        const auto s = projection.project_segment(a, b, 2);
        if (!s) continue;
        for (const PixelPoint& p : {s->a, s->b}) {
            EXPECT_GE(p.x, -2.001);
            EXPECT_LE(p.x, 82.001);
            EXPECT_GE(p.y, -2.001);
            EXPECT_LE(p.y, 62.001);
            EXPECT_GT(p.depth, 0);
        }
    }
}

}  // namespace
}  // namespace kd
