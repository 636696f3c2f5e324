// What legends say: the figure's and the window's alike.
#include "viz/legend_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kd {
namespace {

std::string value_of(const LegendText& text, const std::string& label) {
    const auto row = std::ranges::find(text.rows, label, &LegendRow::label);
    return row == text.rows.end() ? "" : row->value;
}

ScalarMap counts() {
    ScalarMap map;
    map.title = "nodes";
    map.subject = "primary rays";
    map.unit = "visits";
    map.values = Image<float>(100, 1, 10.0f);
    map.values.pixels[0] = 90;
    map.values.pixels[1] = NAN;
    return map;
}

LegendText text_of(const ScalarMap& map, const HeatmapConfig& config) {
    return legend_text(map, config, summarise_map(map, config), count_categories(map));
}

TEST(LegendText, NamesScaleRangeAndWhatLiesBeyondIt) {
    HeatmapConfig config{.range_mode = RangeMode::locked, .range_min = 0, .range_max = 68};
    const LegendText text = text_of(counts(), config);
    EXPECT_EQ(text.subject, "primary rays");
    EXPECT_EQ(text.scale, "visits · linear scale");
    EXPECT_EQ(value_of(text, "range"), "0 – 68, locked");
    EXPECT_EQ(value_of(text, "max"), "90");
    EXPECT_EQ(value_of(text, "above 68"), "1.0 %");
    EXPECT_EQ(value_of(text, "no value"), "1.0 %");
    EXPECT_EQ(value_of(text, "below 0"), "");
    config.logarithmic = true;
    EXPECT_EQ(text_of(counts(), config).scale, "visits · log scale");
}

TEST(LegendText, TicksLieWhereTheirValuesAre) {
    const LegendText text = text_of(counts(), {.range_mode = RangeMode::fixed, .range_min = 0, .range_max = 100});
    ASSERT_GE(text.ticks.size(), 3u);
    for (const LegendTick& tick : text.ticks) EXPECT_FLOAT_EQ(tick.position, std::stof(tick.text) / 100) << tick.text;
}

TEST(LegendText, CategoriesHaveRowsAndNoTicks) {
    ScalarMap map;
    map.categories = {"miss", "hit"};
    map.values = Image<float>(4, 1, 1.0f);
    map.values.pixels[0] = 0;
    const LegendText text = text_of(map, {});
    EXPECT_TRUE(text.ticks.empty() && text.scale.empty());
    ASSERT_EQ(text.rows.size(), 2u);
    EXPECT_EQ(value_of(text, "hit"), "3  75 %");
    EXPECT_EQ(text.rows[1].swatch, category_colour(1));
}

TEST(LegendText, RareValuesKeepABarInTheHistogram) {
    EXPECT_EQ(histogram_length(0, 1000, 50, 1), 0);
    EXPECT_EQ(histogram_length(1, 1000000, 50, 1), 1);
    EXPECT_EQ(histogram_length(500, 1000, 50, 1), 25);
    EXPECT_EQ(histogram_length(0, 0, 50, 1), 0);
}

}  // namespace
}  // namespace kd
