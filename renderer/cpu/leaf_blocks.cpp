#include "renderer/cpu/leaf_blocks.h"

#include <algorithm>
#include <atomic>

#include "renderer/cpu/threads.h"

namespace kd {

namespace {

constexpr std::size_t nodes_per_task = 4096;  // some 100 µs, after which a stop request is seen

void place(LeafBlock& block, std::size_t lane, std::int32_t number, const Triangle& triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            block.corner[corner][std::size_t(axis)][lane] = triangle.corner[corner][axis];
    block.triangle[lane] = number;
}

/// The triangles `numbers`, from the block `first` on.
void fill(const std::int32_t* numbers, int count, const std::vector<Triangle>& triangles, LeafBlock* first) {
    for (int i = 0; i < blocks_of(count) * block_size; ++i) {
        const std::int32_t number = numbers[std::min(i, count - 1)];
        place(first[i / block_size], std::size_t(i % block_size), number, triangles[std::size_t(number)]);
    }
}

/// The last leaf has the last blocks.
std::size_t block_count(const KdTree& over_blocks) {
    const auto last = std::ranges::find_if(over_blocks.nodes.rbegin(), over_blocks.nodes.rend(), &TreeNode::is_leaf);
    return std::size_t(last->link) + std::size_t(blocks_of(last->count));
}

}  // namespace

KdTree tree_over_blocks(const KdTree& tree) {
    KdTree over{tree.nodes, {}, tree.bounds};
    std::int32_t blocks = 0;
    for (TreeNode& node : over.nodes) {
        if (!node.is_leaf()) continue;
        node.link = blocks;
        blocks += blocks_of(node.count);
    }
    return over;
}

std::vector<LeafBlock> make_leaf_blocks(const KdTree& tree, const KdTree& over_blocks,
                                        const std::vector<Triangle>& triangles, int threads,
                                        const std::stop_token& stop) {
    std::vector<LeafBlock> blocks(block_count(over_blocks));
    std::atomic<bool> stopped = false;
    parallel_ranges(tree.nodes.size(), nodes_per_task, threads, [&](std::size_t first, std::size_t last) {
        if (stop.stop_requested()) stopped = true;
        for (std::size_t i = first; i < last && !stopped; ++i) {
            const TreeNode& leaf = tree.nodes[i];
            if (leaf.is_leaf())
                fill(tree.references.data() + leaf.link, leaf.count, triangles,
                     blocks.data() + over_blocks.nodes[i].link);
        }
    });
    if (stopped) blocks = {};
    return blocks;
}

}  // namespace kd
