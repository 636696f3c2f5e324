// Colours of cells by visits: values by hand, scales, and the lines of pictures.

#include "viz/cell_colours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/geometry/input_error.h"
#include "tests/viz/golden.h"
#include "tests/viz/synthetic.h"
#include "viz/figure.h"
#include "viz/legend_text.h"

namespace kd {
namespace {

/// Of three_leaf_tree(): areas 96, 64, 64, 46 and 34.
NodeVisits known_visits() { return {.count = {48, 32, 64, 0, 17}, .rays = 48, .kind = Pass::shade_prim}; }

TEST(CellColours, ValuesPerRay) {
    const KdTree tree = test::three_leaf_tree();
    const NodeVisits visits = known_visits();
    const auto values = [&](CellColour colour) {
        return cell_colours(tree, colour, 64, "viridis", &visits).scale.map.values.pixels;
    };
    EXPECT_EQ(values(CellColour::visits), (std::vector<float>{1, 32.0f / 48, 64.0f / 48, 0, 17.0f / 48}));
    EXPECT_EQ(values(CellColour::predicted),
              (std::vector<float>{1, 64.0f / 96, 64.0f / 96, float(46.0 / 96), float(34.0 / 96)}));
    EXPECT_EQ(values(CellColour::ratio), (std::vector<float>{1, 1, 2, 0, 1}));
}

TEST(CellColours, RatiosDivergeAroundOne) {
    const NodeVisits visits = known_visits();
    const CellColours made = cell_colours(test::three_leaf_tree(), CellColour::ratio, 64, "viridis", &visits);
    const HeatmapConfig& heat = made.scale.heat;
    EXPECT_TRUE(heat.logarithmic);
    EXPECT_TRUE(get_colormap(heat.colormap).diverging);
    EXPECT_FLOAT_EQ(heat.range_min * heat.range_max, 1);
    EXPECT_FLOAT_EQ(heat.range_max, 2) << "never a narrower scale";
    const Colormap& colours = get_colormap(heat.colormap);
    EXPECT_EQ(made.of_node[0], colours(0.5f)) << "as predicted";
    EXPECT_EQ(made.of_node[2], colours(1));
    EXPECT_EQ(made.of_node[3], colours.below) << "never visited";
    ASSERT_EQ(made.scale.map.facts.size(), 1u);
    EXPECT_EQ(made.scale.map.facts[0].value, "1 of 5 cells");
    EXPECT_EQ(made.scale.map.subject, "shadow rays");
}

TEST(CellColours, TheMostCrowdedCellIsNotClipped) {
    NodeVisits visits = known_visits();
    visits.count[4] = 17 * 7;
    const CellColours made = cell_colours(test::three_leaf_tree(), CellColour::ratio, 64, "viridis", &visits);
    EXPECT_FLOAT_EQ(made.scale.heat.range_max, 7);
    EXPECT_EQ(made.scale.summary.above, 0);
    visits.count[4] = 17 * 70;
    const MapSummary wild =
        cell_colours(test::three_leaf_tree(), CellColour::ratio, 64, "viridis", &visits).scale.summary;
    EXPECT_FLOAT_EQ(wild.range.max, 20) << "a scale that tells two from four";
    EXPECT_EQ(wild.above, 1);
}

TEST(CellColours, OnlyCellsShownMakeTheScale) {
    const NodeVisits visits = known_visits();
    const CellColours made = cell_colours(test::three_leaf_tree(), CellColour::visits, 1, "viridis", &visits);
    EXPECT_EQ(made.scale.map.values.width, 3);
    EXPECT_EQ(made.scale.summary.missing, 0);
    EXPECT_EQ(made.of_node.size(), 5u);
    EXPECT_EQ(made.of_node[3], untraced_colour);
    EXPECT_EQ(made.of_node[1], get_colormap("viridis")(0)) << "the least";
    EXPECT_EQ(made.of_node[2], get_colormap("viridis")(1)) << "the most";
}

TEST(CellColours, NothingCountedHasNoValuesButThePredictionNeedsNone) {
    const KdTree tree = test::three_leaf_tree();
    const NodeVisits other_tree{.count = {1, 2, 3}, .rays = 1};
    const NodeVisits none{.count = {0, 0, 0, 0, 0}};
    for (const NodeVisits* visits : {static_cast<const NodeVisits*>(nullptr), &other_tree, &none}) {
        for (const CellColour colour : {CellColour::visits, CellColour::ratio}) {
            const CellColours made = cell_colours(tree, colour, 64, "viridis", visits);
            EXPECT_EQ(made.scale.summary.count, 0);
            for (const Rgba8& c : made.of_node) EXPECT_EQ(c, untraced_colour);
            EXPECT_FALSE(made.scale.map.facts.empty()) << "the legend says why";
            const LegendText legend = legend_text(made.scale.map, made.scale.heat, made.scale.summary, {});
            EXPECT_TRUE(legend.ticks.empty()) << "no invented scale";
        }
        EXPECT_EQ(cell_colours(tree, CellColour::predicted, 64, "viridis", visits).scale.summary.count, 5);
    }
    const CellScale unseen = cell_colours(tree, CellColour::visits, 64, "viridis", &none).scale;
    EXPECT_EQ(unseen.map.subject, "primary rays");
    EXPECT_EQ(unseen.map.facts[0].value, "no such rays");
    EXPECT_THROW((void)cell_colours(tree, CellColour::predicted, 64, "nonsense", nullptr), InputError);
}

TEST(CellColours, EachHasANameAndASentence) {
    ASSERT_EQ(all_cell_colours().size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(int(all_cell_colours()[i].id), int(i)) << "panels choose by number";
        EXPECT_FALSE(all_cell_colours()[i].summary.empty());
    }
}

TEST(CellColours, OfAPictureWithItsLegend) {
    const KdTree tree = test::three_leaf_tree();
    const Frame frame = test::ball_frame();
    const NodeVisits visits = known_visits();
    ViewConfig view;
    view.show_map = false;
    view.overlay.show = true;
    view.overlay.hidden_line = false;
    view.overlay.colour = CellColour::ratio;
    EXPECT_TRUE(needs_visits(view));
    const BesideFrame beside{nullptr, nullptr, &visits};
    test::expect_golden(make_picture(frame, tree, test::ball_camera(), view, beside), "cells_ratio");
    const std::optional<CellColours> cells = view_cells(tree, view, beside);
    ASSERT_TRUE(cells);
    EXPECT_EQ(make_legend(tree, view, std::nullopt, cells, Font{}),
              draw_legend(cells->scale.map, cells->scale.heat, cells->scale.summary, Font{}));
    view.overlay.colour = CellColour::depth;
    EXPECT_FALSE(needs_visits(view));
    EXPECT_FALSE(view_cells(tree, view, beside)) << "depths have a legend of their own";
    view.overlay = {.show = false, .colour = CellColour::visits};
    EXPECT_FALSE(needs_visits(view)) << "nobody sees them";
}

}  // namespace
}  // namespace kd
