#include "viz/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"
#include "viz/heatmap.h"
#include "viz/projection.h"

namespace kd {
namespace {

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

// The cells along the ray through a pixel beside the ball, over the picture.
TEST(OverlayGolden, CellsAlongARay) {
    const Scene scene;
    const Vec3 eye = test::ball_camera().eye;
    const Vec3 direction(test::pixel_direction(scene.camera, 6, 8, test::frame_width, test::frame_height));
    Image<Rgba8> image = paint_beauty(scene.frame);
    OverlayConfig config;
    config.hidden_line = false;
    draw_lines(image, lines_along_ray(test::three_leaf_tree(), {eye, direction, 0, 1e30f, -1}, 100), scene.camera,
               scene.frame, config);
    test::expect_golden(image, "picture_ray_cells", test::of_lines);
}

TEST(RayCells, AreTheLinesAlongThePixelsRayInThePicture) {
    const Scene scene;
    const KdTree tree = test::three_leaf_tree();
    const Projection projection(scene.camera, test::frame_width, test::frame_height);
    for (const auto& [x, y] : {std::pair{6, 8}, {32, 24}, {60, 40}}) {
        const Vec3 direction(test::pixel_direction(scene.camera, x, y, test::frame_width, test::frame_height));
        const Hit& hit = scene.frame.layer(Pass::rt_prim).hit.at(x, y);
        const float t_end = hit.triangle >= 0 ? hit.t : 1e30f;
        std::vector<ScreenLine> expected;
        for (const WorldLine& line : lines_along_ray(tree, {scene.camera.eye, direction, 0, 1e30f, -1}, t_end)) {
            if (const auto s = projection.project_segment(line.a, line.b))
                expected.push_back({float(s->a.x), float(s->a.y), float(s->b.x), float(s->b.y), line.depth});
        }
        const auto cells = ray_cells(tree, scene.camera, test::frame_width, test::frame_height, x, y, hit);
        ASSERT_EQ(cells.size(), expected.size()) << x << "," << y;
        EXPECT_GT(cells.size(), 8u);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            EXPECT_EQ(cells[i].depth, expected[i].depth);
            EXPECT_FLOAT_EQ(cells[i].x0, expected[i].x0);
            EXPECT_FLOAT_EQ(cells[i].y1, expected[i].y1);
        }
    }
}

TEST(RayCells, AHitOnTheFaceOfALeafIsInIt) {
    const Scene scene;
    const auto leaf = [&](const Hit& hit) {
        return leaf_on_ray(test::three_leaf_tree(), 3, scene.camera, test::frame_width, test::frame_height, 44, 30,
                           hit);
    };
    const RayLeaf passed = leaf({-1, 0, 0, 0});
    ASSERT_GT(passed.enters, 0.0f);
    ASSERT_GT(passed.leaves, passed.enters);
    const float before = std::nextafter(passed.enters, 0.0f);
    const RayLeaf touched = leaf({3, before, 0, 0});
    EXPECT_EQ(touched.enters, before) << "the hit is rounded to an ulp before the face";
    EXPECT_EQ(touched.leaves, before);
    EXPECT_TRUE(std::isnan(leaf({3, 0.9f * passed.enters, 0, 0}).enters)) << "and this one lies before it";
}

TEST(RayCells, EndAtTheHitAndAtTheLimit) {
    const Scene scene;
    const auto cells_to = [&](const Hit& hit, std::size_t most) {
        return ray_cells(test::three_leaf_tree(), scene.camera, test::frame_width, test::frame_height, 44, 10, hit,
                         most);
    };
    const Hit none{-1, 0, 0, 0};
    EXPECT_EQ(cells_to(none, 5).size(), 5u);
    EXPECT_LT(cells_to({3, 1.1f, 0, 0}, 4000).size(), cells_to(none, 4000).size());
    EXPECT_TRUE(ray_cells(KdTree{}, scene.camera, 64, 48, 20, 24, none).empty()) << "no triangles, no cells";
}

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
