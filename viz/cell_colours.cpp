#include "viz/cell_colours.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "renderer/geometry/order_statistics.h"
#include "viz/tree_lines.h"

namespace kd {

namespace {

/// Ends of the scale of ratios: a ratio that varies less than twofold should not look wild, and one that varies a
/// thousandfold leaves no colours to tell two from four. Beyond them colours are clipped, and the legend says of how
/// many cells.
constexpr float least_reach = 2, most_reach = 20;

/// The cells down to a depth, in no order that matters.
std::vector<Cell> shallow_cells(const KdTree& tree, int max_depth) {
    std::vector<Cell> cells{{0, 0, tree.bounds}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell cell = cells[i];
        const TreeNode& node = tree.nodes[std::size_t(cell.node)];
        if (node.is_leaf() || cell.depth >= max_depth) continue;
        cells.push_back(child_below(node, cell));
        cells.push_back(child_above(node, cell));
    }
    return cells;
}

/// Of a node: how often a ray comes by, counted and predicted.
struct CellVisits {
    double counted = 0, predicted = 0;
};

double value_of(CellColour colour, const CellVisits& visits) {
    switch (colour) {
        case CellColour::depth: break;
        case CellColour::visits: return visits.counted;
        case CellColour::predicted: return visits.predicted;
        case CellColour::ratio: return visits.counted / visits.predicted;
    }
    return std::nan("");
}

ScalarMap labels_of(CellColour colour, const NodeVisits* visits, bool counted) {
    ScalarMap map;
    map.title = colour == CellColour::ratio       ? "cells: visits over predicted"
                : colour == CellColour::predicted ? "cells: visits predicted"
                                                  : "cells: visits";
    map.unit = colour == CellColour::ratio ? "ratio" : "visits per ray";
    map.integer = false;
    map.counted = "cells";
    map.subject = "uniform lines";
    if (!needs_visits(colour)) return map;
    map.subject = fmt::format("{} rays", ray_names[std::size_t(visits ? visits->kind : Pass::rt_prim)]);
    if (visits && visits->rays == 0)
        map.facts.push_back({"visits", "no such rays"});
    else if (!counted)  // or only in another tree
        map.facts.push_back({"visits", "not counted yet"});
    return map;
}

/// Down to the least that was visited. A percentile would cut off the few nodes at the root, which most rays visit.
HeatmapConfig from_end_to_end(HeatmapConfig heat, const ScalarMap& map) {
    float least = HUGE_VALF, most = 0;
    for (const float v : map.values.pixels)
        if (std::isfinite(v) && v > 0) {
            least = std::min(least, v);
            most = std::max(most, v);
        }
    if (most == 0) return heat;
    heat.range_mode = RangeMode::fixed;
    heat.range_min = least;
    heat.range_max = most;
    return heat;
}

constexpr int ramp_pieces = 36;

/// By depth, as the splits over the picture have it, from the root to the deepest node.
NodeColours colours_by_depth(const KdTree& tree) {
    const std::vector<int> depths = node_depths(tree);
    const int deepest = std::max(1, *std::ranges::max_element(depths));
    NodeColours colours{{}, {0, float(deepest)}, {}};
    for (int depth = 0; depth <= deepest; ++depth) colours.ramp.push_back(depth_colour(depth, deepest));
    colours.of.reserve(depths.size());
    for (const int depth : depths) colours.of.push_back(colours.ramp[std::size_t(depth)]);
    return colours;
}

/// Logarithmic; ratios by as much below 1 as above.
HeatmapConfig heat_of(CellColour colour, const std::string& colormap, const ScalarMap& map) {
    HeatmapConfig heat{.colormap = colormap, .logarithmic = true};
    if (colour != CellColour::ratio) return from_end_to_end(heat, map);
    if (!get_colormap(colormap).diverging) heat.colormap = "blue-grey-orange";
    std::vector<float> factors;  // away from 1, either way
    float most = 0;
    for (const float v : map.values.pixels)
        if (std::isfinite(v) && v > 0) {
            factors.push_back(std::max(v, 1 / v));
            most = std::max(most, v);
        }
    // The cell that rays crowd around most is what people look for; of those that few reach, the rarest tenth may be
    // clipped.
    const float reach = factors.empty() ? least_reach : std::max(percentile(factors, 0.9), most);
    heat.range_mode = RangeMode::fixed;
    heat.range_max = std::clamp(reach, least_reach, most_reach);
    heat.range_min = 1 / heat.range_max;
    return heat;
}

}  // namespace

std::span<const CellColourInfo> all_cell_colours() {
    static constexpr std::array<CellColourInfo, 4> table{{
        {CellColour::depth, "depth", "Pale at the root, dark at the deepest splits shown."},
        {CellColour::visits, "visits",
         "How often a ray visits the cell's node, counted over the rays shown that meet the tree. Logarithmic."},
        {CellColour::predicted, "predicted",
         "How often it should: the cell's share of the root's surface, which is all that the surface area heuristic "
         "knows "
         "of rays. Logarithmic."},
        {CellColour::ratio, "ratio",
         "Visits counted over visits predicted. Below 1, rays end before they come here, or come another way; above 1 "
         "lies what the rays crowd around. Logarithmic around 1."},
    }};
    return table;
}

bool needs_visits(CellColour colour) { return colour == CellColour::visits || colour == CellColour::ratio; }

CellColours cell_colours(const KdTree& tree, CellColour colour, int max_depth, const std::string& colormap,
                         const NodeVisits* visits) {
    assert(colour != CellColour::depth);
    const bool counted = visits && visits->rays > 0 && visits->count.size() == tree.nodes.size();
    const double root_area = tree.bounds.surface_area();
    const std::vector<Cell> cells = shallow_cells(tree, max_depth);
    CellColours made;
    CellScale& scale = made.scale;
    scale.map = labels_of(colour, visits, counted);
    scale.map.values = Image<float>(int(cells.size()), 1, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!counted && needs_visits(colour)) break;
        CellVisits of_a_ray;
        of_a_ray.predicted = root_area > 0 ? cells[i].box.surface_area() / root_area : 1;
        if (counted) of_a_ray.counted = double(visits->count[std::size_t(cells[i].node)]) / double(visits->rays);
        scale.map.values.pixels[i] = float(value_of(colour, of_a_ray));
    }
    const auto idle = std::ranges::count(scale.map.values.pixels, 0.0f);
    if (idle > 0) scale.map.facts.push_back({"never visited", fmt::format("{} of {} cells", idle, cells.size())});
    scale.heat = heat_of(colour, colormap, scale.map);
    scale.summary = summarise_map(scale.map, scale.heat);
    const Image<Rgba8> colours = paint_map(scale.map, scale.heat, scale.summary.range);
    made.of_node.assign(tree.nodes.size(), untraced_colour);
    for (std::size_t i = 0; i < cells.size(); ++i) made.of_node[std::size_t(cells[i].node)] = colours.pixels[i];
    return made;
}

NodeColours colour_nodes(const KdTree& tree, CellColour colour, const std::string& colormap,
                         const NodeVisits* counted) {
    if (colour == CellColour::depth) return colours_by_depth(tree);
    if (needs_visits(colour) && !counted) return {};
    CellColours made = cell_colours(tree, colour, max_tree_depth, colormap, counted);
    NodeColours colours{std::move(made.of_node), made.scale.summary.range, {}};
    const Colormap& map = get_colormap(made.scale.heat.colormap);
    for (int i = 0; i < ramp_pieces; ++i) colours.ramp.push_back(map((float(i) + 0.5f) / ramp_pieces));
    return colours;
}

}  // namespace kd
