#include "viz/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"
#include "viz/canvas.h"
#include "viz/overlay.h"

namespace kd {
namespace {

Image<Rgba8> legend_of(const ScalarMap& map, const HeatmapConfig& config, const Font& font = {}, int scale = 1) {
    return draw_legend(map, config, summarise_map(map, config), font, scale);
}

ScalarMap nodes() { return compute_map(test::ball_frame(), {}); }

int count_colour(const Image<Rgba8>& image, Rgba8 colour) { return int(std::ranges::count(image.pixels, colour)); }

TEST(Legend, BarShowsTheMapFromEndToEnd) {
    const Image<Rgba8> legend = legend_of(nodes(), {});
    const Colormap& viridis = get_colormap("viridis");
    // The bar is the only place with the map's colours: 200 rows of 20 pixels.
    for (const float x : {0.0025f, 0.2525f, 0.5025f, 0.7525f, 0.9975f}) {
        EXPECT_GE(count_colour(legend, viridis(x)), 20) << x;
    }
}

TEST(Legend, ClippedMissingAndBrokenValuesAppearWhereTheyOccur) {
    ScalarMap map = nodes();
    HeatmapConfig config;
    config.range_mode = RangeMode::fixed;
    config.range_min = 0;
    config.range_max = 1000;
    for (float& v : map.values.pixels) v = std::isnan(v) ? 3.0f : v;
    const Image<Rgba8> plain = legend_of(map, config);
    EXPECT_EQ(count_colour(plain, untraced_colour), 0);
    EXPECT_EQ(count_colour(plain, nan_colour), 0);

    map.values.pixels[5] = std::nanf("");
    const Image<Rgba8> missing = legend_of(map, config);
    EXPECT_EQ(count_colour(missing, untraced_colour), 100) << "a swatch of 10x10";
    EXPECT_GT(missing.height, plain.height);

    map.values.pixels[6] = INFINITY;
    EXPECT_EQ(count_colour(legend_of(map, config), nan_colour), 100);

    const Rgba8 above = get_colormap("viridis").above;
    EXPECT_EQ(count_colour(plain, above), 0);
    config.range_max = 5;
    EXPECT_GE(count_colour(legend_of(map, config), above), 150) << "swatch and cap of clipped values";
}

TEST(Legend, HistogramGrowsWithTheCounts) {
    ScalarMap map;
    map.title = "t";
    map.values = Image<float>(100, 1, 1.0f);
    for (std::size_t i = 0; i < 25; ++i) map.values.pixels[i] = 9;
    HeatmapConfig config{.range_mode = RangeMode::fixed, .range_min = 0, .range_max = 10};
    const Image<Rgba8> legend = legend_of(map, config);
    std::vector<int> lengths;
    for (int y = 0; y < legend.height; ++y) {
        int length = 0;
        for (int x = 0; x < legend.width; ++x) length += legend.at(x, y) == figure_style::histogram ? 1 : 0;
        if (length > 0 && (lengths.empty() || lengths.back() != length)) lengths.push_back(length);
    }
    ASSERT_EQ(lengths.size(), 2u) << "two bars: of 9 above, of 1 below";
    EXPECT_EQ(lengths[1], 68);
    EXPECT_EQ(lengths[0], 68 / 3);
}

TEST(Legend, ScaleMultipliesTheBar) {
    const Image<Rgba8> one = legend_of(nodes(), {}, {}, 1);
    const Image<Rgba8> two = legend_of(nodes(), {}, {}, 2);
    EXPECT_EQ(two.width, 2 * one.width);
    EXPECT_GT(two.height, one.height * 3 / 2);
}

TEST(Legend, CategoriesHaveSwatchesAndNoBar) {
    MapConfig config;
    config.map = "exit";
    const ScalarMap map = compute_map(test::ball_frame(), config);
    const Image<Rgba8> legend = legend_of(map, {});
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(count_colour(legend, category_colour(i)), 100) << map.categories[std::size_t(i)];
    EXPECT_EQ(count_colour(legend, figure_style::histogram), 0);
}

TEST(Legend, EmptyMapStillHasOne) {
    ScalarMap map;
    map.title = "nothing";
    map.values = Image<float>(2, 2, std::nanf(""));
    EXPECT_GT(legend_of(map, {}).height, 200);
    map.values = Image<float>();
    HeatmapConfig log;
    log.logarithmic = true;
    EXPECT_GT(legend_of(map, log).height, 200);
}

TEST(Figure, HoldsPictureLegendTitleAndCaption) {
    const Image<Rgba8> picture(100, 80, {1, 2, 3, 255});
    const Image<Rgba8> legend(30, 120, {4, 5, 6, 255});
    const Image<Rgba8> figure =
        compose_figure(picture, legend, "title", "a caption that is too long for one line", Font{});
    EXPECT_EQ(figure.width, 100 + 30 + 3 * figure_style::margin);
    EXPECT_EQ(count_colour(figure, {1, 2, 3, 255}), 100 * 80);
    EXPECT_EQ(count_colour(figure, {4, 5, 6, 255}), 30 * 120);
    EXPECT_GT(count_colour(figure, figure_style::text), 20);
    EXPECT_GT(count_colour(figure, figure_style::dim_text), 20);
    const Image<Rgba8> bare = compose_figure(picture, {}, "", "", Font{});
    EXPECT_EQ(bare.width, 100 + 2 * figure_style::margin);
    EXPECT_EQ(bare.height, 80 + 2 * figure_style::margin);
}

TEST(Figure, StackLeavesEmptyImagesOut) {
    const Image<Rgba8> a(10, 5), b(20, 7);
    EXPECT_EQ(stack_images({a, {}, b}, 3), stack_images({a, b}, 3));
    EXPECT_EQ(stack_images({a, b}, 3).width, 20);
    EXPECT_EQ(stack_images({a, b}, 3).height, 15);
    EXPECT_TRUE(stack_images({{}, {}}, 3).empty());
}

// The built-in letters are made of whole pixels.
TEST(LegendGolden, BuiltInFont) { test::expect_golden(legend_of(nodes(), {}), "legend_dots"); }

TEST(LegendGolden, EverythingThatIsNotOnTheBar) {
    ScalarMap map = nodes();
    map.values.pixels[5] = INFINITY;
    const HeatmapConfig locked{.colormap = "magma", .range_mode = RangeMode::locked, .range_min = 6, .range_max = 20};
    test::expect_golden(legend_of(map, locked), "legend_clipped");
    const HeatmapConfig log{.colormap = "turbo", .logarithmic = true};
    test::expect_golden(legend_of(nodes(), log), "legend_log", {1, 0.001});
}

TEST(LegendGolden, Categories) {
    test::expect_golden(legend_of(compute_map(test::ball_frame(), {.map = "exit"}), {}), "legend_exit");
}

TEST(LegendGolden, VerdictsWithTheirCounts) {
    const JudgedLayer judged = test::ball_judged();
    test::expect_golden(legend_of(compute_map(test::ball_frame(), {.map = "oracle"}, &judged), {}), "legend_oracle");
}

TEST(LegendGolden, Depths) {
    test::expect_golden(draw_depth_legend({}, 5, Font{}), "legend_depths");
    test::expect_golden(draw_depth_legend({.max_depth = 24, .hidden_line = false}, 24, Font{}, 2),
                        "legend_depths_large");
}

// stb_truetype's coverage depends on the compiler's float code at glyph edges; DejaVu 2.37 has not changed since 2016.
TEST(LegendGolden, DejaVu) {
    const auto font = test::dejavu();
    if (!font) GTEST_SKIP() << "fonts-dejavu-core is not installed";
    MapConfig config;
    config.map = "divergence";
    test::expect_golden(legend_of(compute_map(test::ball_frame(), config), {}, *font), "legend_dejavu", {8, 0.01});
}

}  // namespace
}  // namespace kd
