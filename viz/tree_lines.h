// Cells of a kd-tree on the way down, and their outlines.
#pragma once

#include <limits>
#include <vector>

#include "renderer/kdtree/cell.h"
#include "viz/overlay.h"

namespace kd {

/// The outline of the split plane of `n`, the node of `cell`: 4 lines.
void add_plane(const TreeNode& n, const Cell& cell, std::vector<WorldLine>& lines);
/// The edges of the cell: 12 lines.
void add_box(const Cell& cell, std::vector<WorldLine>& lines);

/// What of the lines lies in a width x height picture; `most` of them, those at the start of the list.
[[nodiscard]] std::vector<ScreenLine> on_screen(const std::vector<WorldLine>& lines, const PinholeCamera& camera,
                                                int width, int height,
                                                std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace kd
