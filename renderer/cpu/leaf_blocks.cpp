#include "renderer/cpu/leaf_blocks.h"

#include <algorithm>

namespace kd {

namespace {

void place(LeafBlock& block, std::size_t lane, std::int32_t number, const Triangle& triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            block.corner[corner][std::size_t(axis)][lane] = triangle.corner[corner][axis];
    block.triangle[lane] = number;
}

}  // namespace

LeafBlocks::LeafBlocks(const KdTree& of, const std::vector<Triangle>& triangles) {
    tree.nodes = of.nodes;
    tree.bounds = of.bounds;
    for (TreeNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        const auto first = of.references.begin() + node.link;
        node.link = std::int32_t(blocks.size());
        for (int block = 0; block < blocks_of(node.count); ++block) {
            LeafBlock& filled = blocks.emplace_back();
            for (int lane = 0; lane < block_size; ++lane) {
                const std::int32_t number = first[std::min(block * block_size + lane, node.count - 1)];
                place(filled, std::size_t(lane), number, triangles[std::size_t(number)]);
            }
        }
    }
}

}  // namespace kd
