#include "viz/figure.h"

#include <gtest/gtest.h>

#include "renderer/geometry/input_error.h"
#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"

namespace kd {
namespace {

Image<Rgba8> picture_of(const ViewConfig& view) {
    return make_picture(test::ball_frame(), test::three_leaf_tree(), test::ball_camera(), view);
}

TEST(Picture, WithoutMapAndSplitsIsTheBeautyImage) {
    ViewConfig view;
    view.show_map = false;
    EXPECT_EQ(picture_of(view), paint_beauty(test::ball_frame()));
    view.show_map = true;
    view.heat.opacity = 0;
    EXPECT_EQ(picture_of(view), paint_beauty(test::ball_frame()));
}

TEST(Picture, OpaqueMapIsThePaintedMap) {
    ViewConfig view;
    view.heat.opacity = 1;
    const ScalarMap map = compute_map(test::ball_frame(), view.map);
    EXPECT_EQ(picture_of(view), paint_map(map, view.heat, choose_range(map, view.heat)));
}

TEST(Picture, SameArgumentsSamePicture) {
    ViewConfig view;
    view.overlay.show = true;
    EXPECT_EQ(picture_of(view), picture_of(view));
}

TEST(Picture, SplitsAreDrawnOverTheMap) {
    ViewConfig view;
    const Image<Rgba8> without = picture_of(view);
    view.overlay.show = true;
    EXPECT_NE(picture_of(view), without);
}

TEST(Picture, BadNamesAreInputErrors) {
    ViewConfig view;
    view.map.map = "no such map";
    EXPECT_THROW(static_cast<void>(picture_of(view)), InputError);
    view = {};
    view.heat.colormap = "no such map";
    EXPECT_THROW(static_cast<void>(picture_of(view)), InputError);
    view.show_map = false;
    EXPECT_NO_THROW(static_cast<void>(picture_of(view)));
}

TEST(MakeLegend, ExplainsWhatIsShown) {
    const KdTree tree = test::three_leaf_tree();
    ViewConfig view;
    const auto map = view_map(test::ball_frame(), view);
    ASSERT_TRUE(map);
    EXPECT_EQ(make_legend(tree, view, map, std::nullopt, Font{}),
              draw_legend(map->map, view.heat, map->summary, Font{}));
    view.overlay.show = true;
    EXPECT_GT(make_legend(tree, view, map, std::nullopt, Font{}).height,
              make_legend(tree, view, std::nullopt, std::nullopt, Font{}).height);
    view.overlay.show = view.show_map = false;
    EXPECT_FALSE(view_map(test::ball_frame(), view));
    EXPECT_TRUE(make_legend(tree, view, std::nullopt, std::nullopt, Font{}).empty());
}

TEST(MakeFigure, ContainsThePicture) {
    const ViewConfig view;
    const Image<Rgba8> figure =
        make_figure(test::ball_frame(), test::three_leaf_tree(), test::ball_camera(), view, "", "", Font{});
    const Image<Rgba8> picture = picture_of(view);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            ASSERT_EQ(figure.at(figure_style::margin + x, figure_style::margin + y), picture.at(x, y)) << x << "," << y;
        }
    }
}

TEST(PictureGolden, SplitsOverMap) {
    ViewConfig view;
    view.overlay.show = true;
    test::expect_golden(picture_of(view), "picture_hidden_line", test::of_lines);
    view.overlay.hidden_line = false;
    test::expect_golden(picture_of(view), "picture_see_through", test::of_lines);
}

TEST(PictureGolden, PlanesAloneAndCellsAlone) {
    ViewConfig view;
    view.show_map = false;
    view.overlay = {.show = true, .boxes = false, .hidden_line = false};
    test::expect_golden(picture_of(view), "picture_planes", test::of_lines);
    view.overlay = {.show = true, .planes = false, .hidden_line = false};
    test::expect_golden(picture_of(view), "picture_cells", test::of_lines);
    view.overlay = {.show = true, .max_depth = 1, .planes = false};
    test::expect_golden(picture_of(view), "picture_cells_depth_1", test::of_lines);
}

// All that a figure is made of: title, map half over the picture, splits, both legends, caption.
TEST(PictureGolden, WholeFigure) {
    ViewConfig view;
    view.overlay.show = true;
    view.map.map = "divergence";
    test::expect_golden(make_figure(test::ball_frame(), test::three_leaf_tree(), test::ball_camera(), view,
                                    "Step efficiency of SIMD groups, primary rays",
                                    "ball, 1 triangle; three-leaf tree; 64 x 48; a caption longer than one line",
                                    Font{}),
                        "figure", test::of_lines);
}

TEST(GoldenPictures, ADifferenceIsShownAndAllowedWithinTheTolerance) {
    const Image<Rgba8> expected(40, 30, {10, 20, 30, 255});
    Image<Rgba8> actual = expected;
    actual.at(7, 9).g = 22;
    const std::filesystem::path out = KD_TEST_OUTPUT_DIR;
    for (const char* kind : {".actual.png", ".diff.png"}) std::filesystem::remove(out / (std::string("self") + kind));
    EXPECT_TRUE(test::compare_pictures(actual, expected, "self", test::of_lines)) << "1 of 1200 pixels, by 2";
    EXPECT_FALSE(std::filesystem::exists(out / "self.actual.png"));
    EXPECT_FALSE(test::compare_pictures(actual, expected, "self", {1, 1})) << "by more than 1";
    EXPECT_FALSE(test::compare_pictures(actual, expected, "self", {2, 0.0005})) << "more than half a pixel";

    const testing::AssertionResult exact = test::compare_pictures(actual, expected, "self", {});
    EXPECT_FALSE(exact);
    EXPECT_NE(std::string(exact.message()).find("self.diff.png"), std::string::npos) << exact.message();
    EXPECT_EQ(read_png(out / "self.actual.png"), actual);
    const Image<Rgba8> difference = read_png(out / "self.diff.png");
    EXPECT_EQ(difference.at(7, 9), (Rgba8{16, 16, 16, 255}));
    EXPECT_EQ(difference.at(8, 9), (Rgba8{0, 0, 0, 255}));
    EXPECT_FALSE(test::compare_pictures(Image<Rgba8>(1, 1), expected, "self", {255, 1})) << "another size";
}

}  // namespace
}  // namespace kd
