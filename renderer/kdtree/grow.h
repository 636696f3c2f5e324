// Growing a tree from the root down: what all builders share. A builder only says where a cell is split.
#pragma once

#include <optional>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/cell_lists.h"

namespace kd {

/// The decision that makes a builder. Cells come in depth-first order, so a splitter may keep data of its own for the
/// unfinished ones as a stack.
class Splitter {
  public:
    virtual ~Splitter() = default;

    /// Where to split the top cell, strictly inside it; nothing makes a leaf. The cell has a surface and more than
    /// BuildConfig::leaf_size triangles.
    [[nodiscard]] virtual std::optional<Split> choose(const Aabb& cell, const CellLists& lists) = 0;

    /// Splits the top cell's lists; the cell below the split is on top afterwards.
    virtual void divide(const Aabb& cell, const Split& split, CellLists& lists) { (void)cell, lists.divide(split); }

    /// The top cell became a leaf.
    virtual void dropped() {}
};

/// Splits as `splitter` says within the limits of the task's configuration. Uses a work list, never recursion.
[[nodiscard]] KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter);

/// Builder::build of a splitter that is made from the task, the triangles' ranges and `more`.
template <class Kind, auto... more>
[[nodiscard]] KdTree grow_with(const BuildTask& task) {
    const TriangleRanges ranges(task.triangles);
    Kind splitter(task, ranges, more...);
    return grow_tree(task, ranges, splitter);
}

/// Axis along which the box is longest; the first of equals.
[[nodiscard]] int longest_axis(const Aabb& box);

}  // namespace kd
