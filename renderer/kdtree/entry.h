// Where in the tree primary rays may begin instead of at the root.
#pragma once

#include <span>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// The nodes that the primary rays of an area of pixels begin at, one for each tile of it.
struct EntryPoints {
    int x0 = 0, y0 = 0;                  // of the first tile
    int tile = 1 << 30;                  // pixels of a tile each way; by default one for the whole area
    int columns = 1;                     // of tiles
    std::vector<std::int32_t> nodes{0};  // row by row

    [[nodiscard]] int at(int x, int y) const {
        return nodes[std::size_t((y - y0) / tile) * std::size_t(columns) + std::size_t((x - x0) / tile)];
    }
};

/// What the pixels [x0, x1) x [y0, y1) of a picture see.
struct SeenArea {
    const PinholeCamera& camera;
    int width = 0, height = 0;  // of the picture
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Where a configuration's primary rays begin: at the root; with TraceConfig::eye_leaf and ropes in the leaf of the eye
/// (the entry nodes of Popov et al. 2007); with TraceConfig::entry_tile at each tile's shaft_entry(). `boxes` are
/// node_boxes(); asked for only where tiles are.
[[nodiscard]] EntryPoints entry_points(const KdTree& tree, std::span<const Aabb> boxes, const TraceConfig& config,
                                       const SeenArea& area);

/// Where an area's own shaft begins: Reshetov, Soupikov, Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005.
/// The deepest node outside of which the shaft meets no leaf that holds a triangle; where it meets none, any leaf.
[[nodiscard]] int shaft_entry(const KdTree& tree, std::span<const Aabb> boxes, const SeenArea& area);

}  // namespace kd
