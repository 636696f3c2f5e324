// The two encodings of the tree's nodes: the paper's texture, one RGBA32F texel per node (its section 2.3.1), and 8
// bytes per node as in "Physically Based Rendering" (Pharr & Humphreys, 2004, section 4.4).
#pragma once

#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// Texel: x = flag, y = split or count, z = link, w = parent. Float holds integers exactly up to 2^24, so larger
/// numbers are refused: InputError with the numbers.
[[nodiscard]] std::vector<Vec4> encode_float4(const KdTree& tree);
[[nodiscard]] KdTree decode_float4(const std::vector<Vec4>& texels, std::vector<std::int32_t> references,
                                   const Aabb& bounds);

/// Largest integer that a float texel addresses exactly.
inline constexpr std::int64_t float_index_limit = std::int64_t(1) << 24;

/// No parent, and the kind of node in two bits that link and count have to spare. As a texel: two words, in this order.
struct PackedNode {
    union {
        float split;          // interior: plane position
        std::uint32_t first;  // leaf: first entry in KdTree::references
    };
    std::uint32_t kind_and_number;  // 2 bits: split axis or KD_LEAF; 30 bits: child above, or number of references

    PackedNode() : first(0), kind_and_number(KD_LEAF) {}
};
static_assert(sizeof(PackedNode) == 8);

/// Nodes in the same order. InputError with the numbers where a link or a count is beyond packed_number_limit.
[[nodiscard]] std::vector<PackedNode> encode_packed(const KdTree& tree);
/// Parents are found again from the children. InputError where there is no node, or a child is none of the nodes.
[[nodiscard]] KdTree decode_packed(const std::vector<PackedNode>& nodes, std::vector<std::int32_t> references,
                                   const Aabb& bounds);

/// Largest number that 30 bits hold.
inline constexpr std::int64_t packed_number_limit = (std::int64_t(1) << 30) - 1;

/// A node of either kind as walks read it; a packed one has no parent to tell.
KD_FN KdNode node_as_read(const TreeNode& n) { return {n.flag, n.split, n.count, n.link, n.parent}; }
KD_FN KdNode node_as_read(const PackedNode& n) {
    const int flag = int(n.kind_and_number & 3), number = int(n.kind_and_number >> 2);
    return {flag, n.split, number, flag == KD_LEAF ? int(n.first) : number, -1};
}

}  // namespace kd
