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

TEST(Projection, PolygonsAreCutToThePicture) {
    const Projection projection(camera_at({0, 0, 4}, {0, 0, 0}, 100, 100), 100, 100);
    const std::vector<Vec3> inside{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    ASSERT_EQ(projection.project_polygon(inside).size(), 4u);
    EXPECT_NEAR(projection.project_polygon(inside)[0].x, 37.5, 1e-4);
    // The whole picture, from a floor that goes past the eye.
    const std::vector<Vec3> wide{{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
    double area = 0;
    const std::vector<PixelPoint> seen = projection.project_polygon(wide);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const PixelPoint &a = seen[i], &b = seen[(i + 1) % seen.size()];
        area += 0.5 * (a.x * b.y - b.x * a.y);
        EXPECT_TRUE(a.x > -1e-6 && a.x < 100 + 1e-6 && a.y > -1e-6 && a.y < 100 + 1e-6);
    }
    EXPECT_NEAR(std::abs(area), 100 * 100, 1e-3);
    const std::vector<Vec3> passes{{-1, -1, 0}, {1, -1, 0}, {1, -1, 20}, {-1, -1, 20}};
    EXPECT_GE(projection.project_polygon(passes).size(), 3u) << "half of it behind the eye";
    const std::vector<Vec3> behind{{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}};
    EXPECT_LT(projection.project_polygon(behind).size(), 3u);
}

TEST(Projection, PointsOfALineAreFoundWhereTheyAreSeen) {
    const int w = 320, h = 200;
    const Projection projection(pinhole(test::ball_camera(), w, h), w, h);
    const Vec3 start(-0.3f, 0.2f, 0.1f);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction(0);
        direction[axis] = 2;
        for (const float s : {-0.4f, 0.0f, 0.3f, 0.5f}) {
            const auto seen = projection.project(start + s * direction);
            ASSERT_TRUE(seen);
            const auto found = projection.nearest_on_line(start, direction, seen->x, seen->y);
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found, s, 1e-5);
        }
    }
    const Projection ahead(camera_at({0, 0, 4}, {0, 0, 0}, w, h), w, h);
    EXPECT_FALSE(ahead.nearest_on_line({0, 0, 0}, {0, 0, 1}, w / 2.0, h / 2.0)) << "it points at the eye";
}

}  // namespace
}  // namespace kd
