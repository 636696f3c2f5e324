// Growing a tree from the root down: what all builders share.
//
// Cells of more than `part_size` triangles are split in rounds, each of them once per round, side by side. What they
// end in are parts: subtrees grown depth first, each by one thread, and joined in depth-first order. Where the parts
// begin depends on the triangles alone, so that the tree is the same whatever the number of threads.
//
// The limit of references is one for the whole tree. Where the tree that would grow without it holds more, cells grow a
// second time, each with an allowance of its own.
#pragma once

#include "renderer/kdtree/splitter.h"

namespace kd {

/// Most triangles of the cell that a part begins with: small enough to share a hundred thousand among some threads,
/// large enough that copying its lists does not count.
inline constexpr std::size_t part_size = 4096;

/// Who is refused a split that would take a tree beyond BuildConfig::reference_cap.
enum class Refusal {
    whole_tree,  // nobody: such a tree is not grown at all
    each_cell,   // whoever needs more than its parent's allowance in proportion to its triangles, and what the cell
                 // before it in the same part has left over
};

/// Splits as `splitter` says within the limits of the task's configuration; nothing where the tree is refused. Uses
/// work lists, never recursion.
[[nodiscard]] std::optional<KdTree> grow_tree(const BuildTask& task, const TriangleRanges& ranges,
                                              std::unique_ptr<Splitter> splitter, Refusal refusal);

}  // namespace kd
