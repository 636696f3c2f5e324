// Growing a tree from the root down: what all builders share.
//
// Cells of more than `part_size` triangles are split in rounds, each of them once per round, side by side. What they
// end in are parts: subtrees grown depth first, each by one thread, and joined in depth-first order. Where the parts
// begin depends on the triangles alone, so that the tree is the same whatever the number of threads.
#pragma once

#include "renderer/kdtree/splitter.h"

namespace kd {

/// Most triangles of the cell that a part begins with: small enough to share a hundred thousand among some threads,
/// large enough that copying its lists does not count.
inline constexpr std::size_t part_size = 4096;

/// Splits as `splitter` says within the limits of the task's configuration. Uses work lists, never recursion.
[[nodiscard]] KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, std::unique_ptr<Splitter> splitter);

}  // namespace kd
