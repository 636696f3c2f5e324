// Who is asked where a cell is split: a person's plane first, then empty space to cut off, then the builder.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/kdtree/splitter.h"

namespace kd {

/// Where a node stands in its tree: the steps from the root, as bits.
struct NodePath {
    int depth = 0;
    std::uint64_t bits = 0;  // one per step, the first lowest: 1 for the child above

    [[nodiscard]] NodePath child(bool above) const { return {depth + 1, bits | std::uint64_t(above) << depth}; }
    bool operator==(const NodePath&) const = default;
};
static_assert(max_tree_depth <= 64, "NodePath::bits has one per level");

/// Answers for the top cell of lists that `splitter` keeps too; both must outlive it.
class PlaneChooser {
  public:
    PlaneChooser(const BuildConfig& config, Splitter& splitter);

    /// BuildConfig::by_hand names a plane for that node.
    [[nodiscard]] bool is_placed(const NodePath& at) const { return find(at) != nullptr; }

    /// That plane, where it lies inside the cell.
    [[nodiscard]] std::optional<Split> by_hand(const NodePath& at, const Aabb& cell, const CellLists& lists) const;

    /// Without people: empty space cut off, else the builder's choice; nothing makes a leaf.
    [[nodiscard]] std::optional<Split> by_rule(const Aabb& cell, const CellLists& lists) const;

  private:
    struct Placed {
        NodePath at;
        const HandSplit* split;
    };

    [[nodiscard]] const HandSplit* find(const NodePath& at) const;
    [[nodiscard]] std::optional<Split> cut_empty_space(const Aabb& cell, const CellLists& lists) const;

    const BuildConfig& config_;
    Splitter& splitter_;
    std::vector<Placed> placed_;
};

}  // namespace kd
