// A colour for every cell by how often rays come by, or how often they should: for lines over a picture, icicle and
// slice alike.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/trace/frame.h"
#include "renderer/trace/node_visits.h"
#include "viz/heatmap.h"
#include "viz/overlay.h"

namespace kd {

struct CellColourInfo {
    CellColour id;
    std::string_view name;     // on the command line: "visits"
    std::string_view summary;  // how to read it, a sentence or two
};

/// All of them, in their order.
[[nodiscard]] std::span<const CellColourInfo> all_cell_colours();

/// What colours of cells stand for: a map with one value for each cell shown, and its scale, for legends.
struct CellScale {
    ScalarMap map;
    HeatmapConfig heat;
    MapSummary summary;
};

struct CellColours {
    std::vector<Rgba8> of_node;  // of every node down to the depth asked for; deeper ones in untraced_colour
    CellScale scale;
};

/// True where a colour cannot be had without counting.
[[nodiscard]] bool needs_visits(CellColour colour);

/// Colours of the cells down to `max_depth`; `colour` is not CellColour::depth (depth_colour()). Visits and predicted
/// visits are per ray that meets the tree's bounds, on a logarithmic scale in `colormap`; their ratio is on one around
/// 1, in a diverging colour map: `colormap` where it is one, else blue-grey-orange. InputError for an unknown one.
/// What needs `visits` has no values without them, nor where no ray came.
[[nodiscard]] CellColours cell_colours(const KdTree& tree, CellColour colour, int max_depth,
                                       const std::string& colormap, const NodeVisits* visits);

/// What the colours of nodes say.
struct NodeColours {
    std::vector<Rgba8> of;    // by node; empty where nobody has counted yet
    ValueRange range;         // values at the two ends of the colours
    std::vector<Rgba8> ramp;  // the colours from end to end
};

/// Of every node of the tree, depths included; `counted` may be null: colours that need it are none then.
[[nodiscard]] NodeColours colour_nodes(const KdTree& tree, CellColour colour, const std::string& colormap,
                                       const NodeVisits* counted);

}  // namespace kd
