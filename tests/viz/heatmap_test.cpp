#include "viz/heatmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"
#include "viz/canvas.h"

namespace kd {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

ScalarMap map_of(std::vector<float> values, bool integer = false) {
    ScalarMap map;
    map.title = "test";
    map.integer = integer;
    map.values = Image<float>(int(values.size()), 1);
    map.values.pixels = std::move(values);
    return map;
}

ScalarMap ramp(int count) {  // 1, 2, ... count
    std::vector<float> values(static_cast<std::size_t>(count));
    std::iota(values.begin(), values.end(), 1.0f);
    return map_of(values, true);
}

HeatmapConfig logarithmic() {
    HeatmapConfig config;
    config.logarithmic = true;
    return config;
}

TEST(Range, AutomaticIsZeroToThe995thPercentile) {
    EXPECT_EQ(choose_range(ramp(1000), {}), (ValueRange{0, 995}));
    EXPECT_EQ(choose_range(ramp(10), {}), (ValueRange{0, 10}));  // nearest rank of few values is the largest
}

TEST(Range, AutomaticLogStartsAtTheLeastPositiveValue) {
    EXPECT_EQ(choose_range(ramp(1000), logarithmic()), (ValueRange{1, 995}));
    EXPECT_EQ(choose_range(map_of({0, -4, nan, 2, 8}), logarithmic()), (ValueRange{2, 8}));
    EXPECT_EQ(choose_range(map_of({0, 0}), logarithmic()), (ValueRange{1, 10}));
}

TEST(Range, SignedMapsStartAtTheLeastValueOrAreSymmetric) {
    EXPECT_EQ(choose_range(map_of({-5, 0, 3}), {}), (ValueRange{-5, 3}));
    HeatmapConfig diverging;
    diverging.colormap = "blue-grey-orange";
    EXPECT_EQ(choose_range(map_of({-5, 0, 3}), diverging), (ValueRange{-5, 5}));
    EXPECT_EQ(choose_range(map_of({0, 0}), diverging), (ValueRange{-1, 1}));
}

TEST(Range, NaturalRangeWins) {
    ScalarMap map = map_of({0.2f, 0.7f});
    map.natural_range = ValueRange{0, 1};
    EXPECT_EQ(choose_range(map, {}), (ValueRange{0, 1}));
    EXPECT_EQ(choose_range(map, logarithmic()), (ValueRange{0.2f, 0.7f}));
}

// Few pixels with a value: the percentile alone would say 0 and hide them.
TEST(Range, RareValuesAreNotHidden) {
    std::vector<float> values(10000, 0.0f);
    values[77] = 5;
    EXPECT_EQ(choose_range(map_of(values, true), {}), (ValueRange{0, 5}));
}

TEST(Range, IsNeverEmpty) {
    const ScalarMap cases[] = {map_of({}),
                               map_of({nan, nan}),
                               map_of({0, 0}),
                               map_of({7, 7}),
                               map_of({-3, -3}),
                               map_of({1e-40f}),
                               map_of({3e38f, -3e38f}),
                               map_of({3.4e38f, 3.4e38f}),
                               map_of({-3.4e38f}),
                               map_of({infinity, -infinity, 2}),
                               map_of({0}, true)};
    for (const ScalarMap& map : cases) {
        for (const bool log : {false, true}) {
            HeatmapConfig config;
            config.logarithmic = log;
            const ValueRange range = choose_range(map, config);
            EXPECT_LT(range.min, range.max);
            EXPECT_TRUE(std::isfinite(range.min) && std::isfinite(range.max));
            if (log) {
                EXPECT_GT(range.min, 0.0f);
            }
        }
    }
    EXPECT_EQ(choose_range(map_of({0, 0}, true), {}), (ValueRange{0, 1}));
}

TEST(Range, FixedAndLockedAreTakenAsGivenUnlessUnusable) {
    HeatmapConfig config;
    for (const RangeMode mode : {RangeMode::fixed, RangeMode::locked}) {
        config.range_mode = mode;
        config.range_min = 10;
        config.range_max = 20;
        EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{10, 20}));
        config.range_min = 30;
        EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{20, 30})) << "reversed";
        config.range_min = config.range_max = 0;
        EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{0, 1})) << "empty";
        config.range_min = nan;
        config.range_max = 5;
        EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{0, 5})) << "not a number";
    }
    config.logarithmic = true;
    config.range_min = 0;
    config.range_max = 1000;
    EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{1, 1000})) << "log has no zero";
    config.range_min = -5;
    config.range_max = -1;
    EXPECT_EQ(choose_range(ramp(1000), config), (ValueRange{1, 10}));
}

TEST(Position, LinearAndLog) {
    EXPECT_EQ(map_position(5, {0, 10}, false), 0.5f);
    EXPECT_EQ(map_position(-1, {0, 10}, false), 0.0f);
    EXPECT_EQ(map_position(11, {0, 10}, false), 1.0f);
    EXPECT_FLOAT_EQ(map_position(10, {1, 100}, true), 0.5f);
    EXPECT_FLOAT_EQ(map_position(10, {1, 1000}, true), 1.0f / 3.0f);
    EXPECT_EQ(map_position(0, {1, 100}, true), 0.0f);
    EXPECT_EQ(map_position(-3, {1, 100}, true), 0.0f);
    EXPECT_TRUE(std::isnan(map_position(nan, {0, 1}, false)));
    EXPECT_TRUE(std::isnan(map_position(nan, {1, 10}, true)));
    // The extent passes the largest float.
    EXPECT_FLOAT_EQ(map_position(0, {-3e38f, 3e38f}, false), 0.5f);
}

TEST(Position, GrowsWithTheValue) {
    for (const bool log : {false, true}) {
        float last = -1;
        for (float v = 1; v <= 500; v += 0.25f) {
            const float position = map_position(v, {1, 500}, log);
            EXPECT_GT(position, last);
            last = position;
        }
    }
}

TEST(Summary, Statistics) {
    const MapSummary s = summarise_map(map_of({4, nan, 1, 3, 2, infinity, 10}), {});
    EXPECT_EQ(s.count, 5);
    EXPECT_EQ(s.missing, 1);
    EXPECT_EQ(s.broken, 1);
    EXPECT_EQ(s.mean, 4.0);
    EXPECT_EQ(s.min, 1.0f);
    EXPECT_EQ(s.max, 10.0f);
}

TEST(Summary, HistogramAndOutsidersAddUp) {
    std::mt19937 random(5);
    std::lognormal_distribution<float> values(2, 1.5f);
    std::vector<float> v(5000);
    for (float& x : v) x = values(random);
    v[3] = nan;
    v[4] = 0;
    v[5] = -1;
    for (const bool log : {false, true}) {
        for (const RangeMode mode : {RangeMode::automatic, RangeMode::fixed}) {
            const HeatmapConfig config{.logarithmic = log, .range_mode = mode, .range_min = 2, .range_max = 30};
            const MapSummary s = summarise_map(map_of(v), config, 40);
            EXPECT_EQ(s.histogram.size(), 40u);
            EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), s.below + s.above), s.count);
            EXPECT_EQ(s.count, 4999);
            if (log) {
                EXPECT_GE(s.below, 2) << "zero and less are below every log range";
            }
        }
    }
}

TEST(Summary, HistogramBinsAreEqualOnTheScale) {
    const HeatmapConfig linear{.range_mode = RangeMode::fixed, .range_min = 0, .range_max = 10};
    EXPECT_EQ(summarise_map(map_of({0, 1, 4.9f, 5, 9, 10, 11, -1}), linear, 2).histogram,
              (std::vector<std::int64_t>{3, 3}));
    const HeatmapConfig log{.logarithmic = true, .range_mode = RangeMode::fixed, .range_min = 1, .range_max = 100};
    EXPECT_EQ(summarise_map(map_of({1, 2, 9, 11, 50, 100, 0}), log, 2).histogram, (std::vector<std::int64_t>{3, 3}));
}

// Every whole number once: no bin may hold twice what another does, apart from the last, which holds its upper end too.
TEST(Summary, WholeNumbersFillBinsEvenly) {
    for (const int count : {5, 32, 64, 65, 128, 192}) {
        const MapSummary s = summarise_map(ramp(count), {}, 64);
        EXPECT_LE(s.histogram.size(), 64u);
        const auto first = s.histogram[1];
        for (std::size_t i = 1; i + 1 < s.histogram.size(); ++i)
            EXPECT_NEAR(double(s.histogram[i]), double(first), count == 65 ? 1 : 0);
    }
}

TEST(Summary, EmptyMap) {
    const MapSummary s = summarise_map(map_of({nan}), {});
    EXPECT_EQ(s.count, 0);
    EXPECT_EQ(s.missing, 1);
    EXPECT_EQ(s.mean, 0.0);
    EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::int64_t(0)), 0);
}

TEST(Paint, EveryKindOfValueHasItsColour) {
    const Colormap& viridis = get_colormap("viridis");
    const Image<Rgba8> image = paint_map(map_of({0, 10, 20, nan, infinity, -infinity, 5, -1}), {}, {0, 10});
    EXPECT_EQ(image.at(0, 0), viridis(0));
    EXPECT_EQ(image.at(1, 0), viridis(1));
    EXPECT_EQ(image.at(2, 0), viridis.above);
    EXPECT_EQ(image.at(7, 0), viridis.below);
    EXPECT_EQ(image.at(3, 0), untraced_colour);
    EXPECT_EQ(image.at(4, 0), nan_colour);
    EXPECT_EQ(image.at(5, 0), nan_colour);
    EXPECT_EQ(image.at(6, 0), viridis(0.5f));
    ScalarMap categories = map_of({1, 3}, true);
    categories.categories = {"a", "b", "c", "d"};
    EXPECT_EQ(paint_map(categories, {}, {0, 1}).at(1, 0), category_colour(3));
}

TEST(Paint, BeautyClampsAndRounds) {
    Frame frame(4, 1);
    frame.colour.at(0, 0) = {-1, 0.5f, 2, 1};
    frame.colour.at(1, 0) = {1, 0, 0.002f, 1};
    frame.colour.at(3, 0) = {nan, 0, 0, 1};
    const Image<Rgba8> image = paint_beauty(frame);
    EXPECT_EQ(image.at(0, 0), (Rgba8{0, 128, 255, 255}));
    EXPECT_EQ(image.at(1, 0), (Rgba8{255, 0, 1, 255}));
    EXPECT_EQ(image.at(2, 0), untraced_colour);
    EXPECT_EQ(image.at(3, 0), nan_colour);
}

TEST(Paint, BlendMixesByOpacityAndAlpha) {
    const Image<Rgba8> bottom(1, 1, {0, 100, 200, 255});
    const Image<Rgba8> top(1, 1, {100, 100, 0, 255});
    EXPECT_EQ(blend(bottom, top, 0), bottom);
    EXPECT_EQ(blend(bottom, top, 1), top);
    EXPECT_EQ(blend(bottom, top, 0.5f).at(0, 0), (Rgba8{50, 100, 100, 255}));
    EXPECT_EQ(blend(bottom, top, 9), top);
    EXPECT_EQ(blend(bottom, Image<Rgba8>(1, 1, {255, 255, 255, 0}), 1), bottom);
}

// Positions on a log scale go through the C library's logarithm, whose last bit may differ between systems.
TEST(PaintGolden, LogScale) {
    const ScalarMap map = compute_map(test::ball_frame(), {});
    HeatmapConfig config = logarithmic();
    config.colormap = "inferno";
    test::expect_golden(paint_map(map, config, choose_range(map, config)), "map_nodes_log", {1, 0.001});
}

// A band per colour map, in their order: from below the range through it to above it, then no value and a broken one.
TEST(PaintGolden, EveryColourMapWithItsExceptions) {
    constexpr int band = 8, ramp_width = 80, swatch = 8;
    ScalarMap map;
    map.values = Image<float>(ramp_width + 2 * swatch, band - 1);
    for (int y = 0; y < map.values.height; ++y) {
        for (int x = 0; x < ramp_width; ++x) map.values.at(x, y) = float(x - swatch);
        for (int x = 0; x < swatch; ++x) {
            map.values.at(ramp_width + x, y) = nan;
            map.values.at(ramp_width + swatch + x, y) = infinity;
        }
    }
    Image<Rgba8> all(map.values.width, band * int(colormaps().size()), Rgba8{128, 128, 128, 255});
    int y = 0;
    for (const Colormap& colours : colormaps()) {
        draw_image(all, 0, y,
                   paint_map(map, {.colormap = std::string(colours.name)}, {0, ramp_width - 2 * swatch - 1}));
        y += band;
    }
    test::expect_golden(all, "colormaps");
}

}  // namespace
}  // namespace kd
