// Leaves as vectors of processors like them: the corners of eight triangles side by side.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// Triangles of a block.
inline constexpr int block_size = 8;

/// By corner and axis. Behind the last triangle of a leaf the last one is repeated.
struct alignas(32) LeafBlock {
    std::array<std::array<std::array<float, block_size>, 3>, 3> corner;
    std::array<std::int32_t, block_size> triangle;
};
static_assert(sizeof(LeafBlock) == 320);

/// Blocks that so many triangles take.
[[nodiscard]] constexpr int blocks_of(int triangles) { return (triangles + block_size - 1) / block_size; }

/// The same nodes; a leaf's link leads to the first of its blocks, which follow each other as the leaves do, and there
/// are no references.
[[nodiscard]] KdTree tree_over_blocks(const KdTree& tree);

/// The leaf lists of `tree`, where `over_blocks` has them, made on `threads` threads (0 = all). Empty where stopped
/// before the end.
[[nodiscard]] std::vector<LeafBlock> make_leaf_blocks(const KdTree& tree, const KdTree& over_blocks,
                                                      const std::vector<Triangle>& triangles, int threads = 0,
                                                      const std::stop_token& stop = {});

}  // namespace kd
