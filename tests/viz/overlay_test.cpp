#include "viz/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tests/viz/synthetic.h"
#include "viz/colormap.h"
#include "viz/projection.h"

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

TEST(SplitLines, PlanesAndBoxesOfASmallTree) {
    const KdTree tree = test::three_leaf_tree();
    OverlayConfig config;
    config.boxes = false;
    const std::vector<WorldLine> planes = split_lines(tree, config);
    ASSERT_EQ(planes.size(), 8u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(planes[i].node, 0);
        EXPECT_EQ(planes[i].depth, 0);
        EXPECT_EQ(planes[i].a.x, 0.0f);
        EXPECT_EQ(planes[i].b.x, 0.0f);
        EXPECT_EQ(glm::length(planes[i].b - planes[i].a), 4.0f) << "an edge of the square [-2,2]^2";
        EXPECT_EQ(planes[i + 4].node, 2);
        EXPECT_EQ(planes[i + 4].depth, 1);
        EXPECT_EQ(planes[i + 4].a.y, 0.5f);
        EXPECT_GE(planes[i + 4].a.x, 0.0f) << "only in the half above x = 0";
    }
    config.boxes = true;
    config.planes = false;
    const std::vector<WorldLine> boxes = split_lines(tree, config);
    ASSERT_EQ(boxes.size(), 36u);
    std::set<int> leaves;
    for (const WorldLine& line : boxes) leaves.insert(line.node);
    EXPECT_EQ(leaves, (std::set<int>{1, 3, 4}));
    config.max_depth = 1;
    EXPECT_EQ(split_lines(tree, config).size(), 24u) << "cells at depth 1 stand for their leaves";
    config.max_depth = 0;
    config.planes = true;
    EXPECT_EQ(split_lines(tree, config).size(), 12u) << "the root's box alone";
}

TEST(SplitLines, LimitKeepsTheShallowestWhole) {
    OverlayConfig config;
    const std::vector<WorldLine> all = split_lines(test::three_leaf_tree(), config);
    ASSERT_EQ(all.size(), 44u);
    const std::vector<WorldLine> some = split_lines(test::three_leaf_tree(), config, 19);
    EXPECT_EQ(some.size(), 16u) << "the root's plane and one box; half a plane is no plane";
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_GE(all[i].depth, all[i - 1].depth);
    EXPECT_TRUE(split_lines(KdTree{}, config).empty()) << "no triangles, no cells";
}

std::vector<int> nodes_along(Vec3 origin, Vec3 direction, float t_end) {
    const Ray ray{origin, direction, 0, 1e30f, -1};
    std::vector<int> nodes;
    for (const WorldLine& line : lines_along_ray(test::three_leaf_tree(), ray, t_end)) {
        if (nodes.empty() || nodes.back() != line.node) nodes.push_back(line.node);
    }
    return nodes;
}

TEST(LinesAlongRay, CellsInTheOrderOfTheRay) {
    EXPECT_EQ(nodes_along({-5, 0, 0}, {1, 0, 0}, 100), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(nodes_along({5, 0, 0}, {-1, 0, 0}, 100), (std::vector<int>{0, 2, 3, 1}));
    EXPECT_EQ(nodes_along({1, 5, 0}, {0, -1, 0}, 100), (std::vector<int>{0, 2, 4, 3}));
    EXPECT_EQ(nodes_along({-5, 0, 0}, {1, 0, 0}, 4), (std::vector<int>{0, 1})) << "stops at t_end";
    EXPECT_TRUE(nodes_along({-5, 9, 0}, {1, 0, 0}, 100).empty()) << "misses the tree";
    EXPECT_EQ(nodes_along({0, 0, -9}, {0, 0, 1}, 100), (std::vector<int>{0, 1, 2, 3}))
        << "inside the plane: both sides";
}

struct Scene {
    Frame frame = test::ball_frame();
    PinholeCamera camera = pinhole(test::ball_camera(), test::frame_width, test::frame_height);

    Image<Rgba8> draw(const std::vector<WorldLine>& lines, const OverlayConfig& config) const {
        Image<Rgba8> image(frame.width, frame.height, {128, 128, 128, 255});
        draw_lines(image, lines, camera, frame, config);
        return image;
    }
};

constexpr Rgba8 untouched{128, 128, 128, 255};

// Row 24 is just below the centre: it crosses the ball of radius 1 seen from distance 3.
std::vector<WorldLine> level_line(float z) { return {{{-5, 0, z}, {5, 0, z}, 0, 0}}; }

TEST(DrawLines, BehindTheBallIsHiddenAndBesideItIsNot) {
    const Scene scene;
    const Image<Rgba8> image = scene.draw(level_line(-1.5f), {});
    EXPECT_EQ(image.at(32, 24), untouched);
    EXPECT_EQ(image.at(32, 23), untouched);
    EXPECT_NE(image.at(3, 24), untouched);
    for (int x = 0; x < test::untraced_from; ++x) {
        const bool ball = scene.frame.layer(Pass::rt_prim).hit.at(x, 24).triangle >= 0;
        EXPECT_EQ(image.at(x, 24) == untouched, ball) << x;
    }
}

TEST(DrawLines, InFrontOfTheBallIsSeen) {
    const Image<Rgba8> image = Scene().draw(level_line(1.2f), {});
    for (int x = 0; x < test::frame_width; ++x) EXPECT_NE(image.at(x, 24), untouched) << x;
}

TEST(DrawLines, OnTheSurfaceIsSeen) {
    // A circle on the ball, a little above the middle, front side.
    std::vector<WorldLine> lines;
    const auto point = [](float a) { return Vec3(0.9539392f * std::sin(a), 0.3f, 0.9539392f * std::cos(a)); };
    for (int i = -8; i < 8; ++i) lines.push_back({point(float(i) * 0.1f), point(float(i + 1) * 0.1f), 0, 0});
    const Scene scene;
    const Image<Rgba8> hidden_line = scene.draw(lines, {});
    OverlayConfig through;
    through.hidden_line = false;
    EXPECT_EQ(hidden_line, scene.draw(lines, through)) << "nothing of it is hidden";
}

TEST(DrawLines, SeeThroughIsFainter) {
    OverlayConfig config;
    config.hidden_line = false;
    const Image<Rgba8> image = Scene().draw(level_line(-1.5f), config);
    const auto change = [&](int x) { return std::abs(image.at(x, 24).r - 128) + std::abs(image.at(x, 24).b - 128); };
    EXPECT_NE(image.at(32, 24), untouched);
    EXPECT_GT(change(3), 2 * change(32));
}

TEST(DrawLines, HasADarkOutline) {
    // On the centre of row 24: y = 0 projects to 24.0, half a pixel lower is row 24's centre.
    Scene scene;
    const Image<Rgba8> image = scene.draw(level_line(1.2f), {});
    const Rgba8 above = image.at(30, 22);
    EXPECT_LT(above.r + above.g + above.b, 3 * 128 - 60);
    const Rgba8 line = image.at(30, 24);
    EXPECT_GT(line.r, 180) << "pale yellow";
    EXPECT_EQ(image.at(30, 20), untouched);
}

TEST(DrawLines, ManyLinesInOnePlaceAreAsStrongAsOne) {
    std::vector<WorldLine> many;
    for (int i = 0; i < 50; ++i) many.push_back(level_line(1.2f).front());
    EXPECT_EQ(Scene().draw(many, {}), Scene().draw(level_line(1.2f), {}));
}

TEST(DrawLines, FirstLineIsOnTop) {
    std::vector<WorldLine> lines = level_line(1.2f);
    lines.push_back(lines.front());
    lines[1].depth = 6;
    EXPECT_EQ(Scene().draw(lines, {}), Scene().draw(level_line(1.2f), {}));
}

TEST(DrawLines, OpacityZeroDrawsNothing) {
    OverlayConfig config;
    config.opacity = 0;
    EXPECT_EQ(Scene().draw(level_line(1.2f), config), Image<Rgba8>(test::frame_width, test::frame_height, untouched));
}

TEST(DrawLines, PointsAndLinesThroughTheEyeDoNoHarm) {
    const std::vector<WorldLine> lines{{{0, 0, 1.5f}, {0, 0, 1.5f}, 0, 0},
                                       {{0, 0, 3}, {0, 0, 3}, 0, 0},
                                       {{0, 0, 3}, {0, 0, -9}, 0, 0},
                                       {{-1, 2, 8}, {1, -2, -2}, 3, 0},
                                       {{1e30f, 0, 0}, {-1e30f, 1, 0}, 3, 0}};
    EXPECT_NE(Scene().draw(lines, {}), Image<Rgba8>(test::frame_width, test::frame_height, untouched));
}

TEST(DepthColour, RootIsLightestAndDeeperOnesDiffer) {
    const auto brightness = [](Rgba8 c) { return 2 * c.r + 7 * c.g + c.b; };
    for (int depth = 0; depth < 6; ++depth) {
        EXPECT_GT(brightness(depth_colour(depth, 6)), brightness(depth_colour(depth + 1, 6))) << depth;
    }
    EXPECT_EQ(depth_colour(99, 6), depth_colour(6, 6));
    EXPECT_EQ(depth_colour(0, 0), depth_colour(0, 6));
}

TEST(DepthLegend, HasASwatchForEveryDepthShown) {
    OverlayConfig config;
    const Image<Rgba8> legend = draw_depth_legend(config, 3, Font{});
    for (int depth = 0; depth <= 3; ++depth) {
        EXPECT_GT(std::ranges::count(legend.pixels, depth_colour(depth, 6)), 500) << depth;
    }
    EXPECT_EQ(std::ranges::count(legend.pixels, depth_colour(4, 6)), 0);
}

}  // namespace
}  // namespace kd
