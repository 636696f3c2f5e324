#include "renderer/kdtree/plane_chooser.h"

#include <algorithm>

namespace kd {

PlaneChooser::PlaneChooser(const BuildConfig& config, Splitter& splitter) : config_(config), splitter_(splitter) {
    for (const HandSplit& split : config.by_hand) {
        NodePath at;
        for (const char step : split.path) at = at.child(step == path_above);
        placed_.push_back({at, &split});
    }
}

const HandSplit* PlaneChooser::find(const NodePath& at) const {
    const auto found = std::ranges::find(placed_, at, &Placed::at);
    return found == placed_.end() ? nullptr : found->split;
}

std::optional<Split> PlaneChooser::by_hand(const NodePath& at, const Aabb& cell, const CellLists& lists) const {
    const HandSplit* placed = find(at);
    if (!placed) return std::nullopt;
    const auto& [path, axis, position] = *placed;
    if (!(position > cell.lower[axis] && position < cell.upper[axis])) return std::nullopt;
    return splitter_.count(axis, position, true, lists);
}

std::optional<Split> PlaneChooser::by_rule(const Aabb& cell, const CellLists& lists) const {
    if (lists.top().size() <= std::size_t(config_.leaf_size)) return std::nullopt;
    if (const std::optional<Split> cut = cut_empty_space(cell, lists)) return cut;
    return splitter_.choose(cell, lists);
}

/// The plane that cuts off the largest share of the top cell without triangles, where that is large enough.
std::optional<Split> PlaneChooser::cut_empty_space(const Aabb& cell, const CellLists& lists) const {
    double largest = double(config_.empty_cut);
    if (!(largest > 0)) return std::nullopt;
    std::optional<Split> best;
    for (int axis = 0; axis < 3; ++axis) {
        const AxisRange covered = lists.covered(axis, cell);
        const double lower = double(cell.lower[axis]), extent = double(cell.upper[axis]) - lower;
        const double before = (double(covered.lower) - lower) / extent;
        const double behind = (double(cell.upper[axis]) - double(covered.upper)) / extent;
        const bool front = before >= behind;
        if (!(std::max(before, behind) >= largest)) continue;
        largest = std::max(before, behind);
        best = splitter_.count(axis, front ? covered.lower : covered.upper, !front, lists);
    }
    return best;
}

}  // namespace kd
