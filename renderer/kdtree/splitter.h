// What makes a builder: the decision where a cell is split.
#pragma once

#include <memory>
#include <optional>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/cell_lists.h"

namespace kd {

/// Cells come in depth-first order, so a splitter may keep data of its own for the unfinished ones as a stack.
class Splitter {
  public:
    virtual ~Splitter() = default;

    /// Where to split the top cell, strictly inside it; nothing makes a leaf. The cell has a surface and more than
    /// BuildConfig::leaf_size triangles.
    [[nodiscard]] virtual std::optional<Split> choose(const Aabb& cell, const CellLists& lists) = 0;

    /// What divide() will make of a plane that something else has chosen, strictly inside the top cell.
    [[nodiscard]] virtual Split count(int axis, float position, bool planar_below, const CellLists& lists) const {
        return lists.count(axis, position, planar_below);
    }

    /// Splits the top cell's lists; the cell below the split is on top afterwards.
    virtual void divide(const Aabb& cell, const Split& split, CellLists& lists) { (void)cell, lists.divide(split); }

    /// The top cell became a leaf.
    virtual void dropped() {}

    /// One for the top cell alone.
    [[nodiscard]] virtual std::unique_ptr<Splitter> top_alone() const = 0;
};

/// Builder::splitter of a kind that is made from the task, the triangles' ranges and `more`.
template <class Kind, auto... more>
[[nodiscard]] std::unique_ptr<Splitter> make_splitter(const BuildTask& task, const TriangleRanges& ranges) {
    return std::make_unique<Kind>(task, ranges, more...);
}

}  // namespace kd
