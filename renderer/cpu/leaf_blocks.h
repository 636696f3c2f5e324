// Leaves as vectors of processors like them: the corners of eight triangles side by side.
#pragma once

#include <array>
#include <cstdint>
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

/// The leaf lists of a tree in blocks.
struct LeafBlocks {
    std::vector<LeafBlock> blocks;
    KdTree tree;  // the same nodes; a leaf's link leads to its first block, and there are no references

    LeafBlocks() = default;
    LeafBlocks(const KdTree& of, const std::vector<Triangle>& triangles);

    [[nodiscard]] bool empty() const { return tree.nodes.size() <= 1 && blocks.empty(); }
};

/// Blocks that so many triangles take.
[[nodiscard]] constexpr int blocks_of(int triangles) { return (triangles + block_size - 1) / block_size; }

}  // namespace kd
