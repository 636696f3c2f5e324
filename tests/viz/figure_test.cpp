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
    EXPECT_EQ(make_legend(tree, view, map, Font{}), draw_legend(map->map, view.heat, map->summary, Font{}));
    view.overlay.show = true;
    EXPECT_GT(make_legend(tree, view, map, Font{}).height, make_legend(tree, view, std::nullopt, Font{}).height);
    view.overlay.show = view.show_map = false;
    EXPECT_FALSE(view_map(test::ball_frame(), view));
    EXPECT_TRUE(make_legend(tree, view, std::nullopt, Font{}).empty());
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

// Lines go through square roots and divisions whose results may round differently with another compiler.
TEST(PictureGolden, SplitsOverMap) {
    ViewConfig view;
    view.overlay.show = true;
    test::expect_golden(picture_of(view), "picture_hidden_line", {2, 0.001});
    view.overlay.hidden_line = false;
    test::expect_golden(picture_of(view), "picture_see_through", {2, 0.001});
}

}  // namespace
}  // namespace kd
