// The two encodings of the tree's nodes: the paper's texture, one RGBA32F texel per node (its section 2.3.1), and 8
// bytes per node after "Physically Based Rendering" (Pharr & Humphreys, 2004, section 4.4).
#pragma once

#include <bit>
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

/// No parent, and the kind of node in two bits that the link has to spare. The link stands in one place for both kinds,
/// so that reading a node takes no choice. As a texel: two words, in this order.
struct PackedNode {
    std::uint32_t value = 0;                // interior: the bits of the plane's position; leaf: number of references
    std::uint32_t kind_and_link = KD_LEAF;  // 2 bits: split axis or KD_LEAF; 30 bits: child above, or first reference
};
static_assert(sizeof(PackedNode) == 8);

/// Nodes in the same order. InputError with the numbers where a link is beyond packed_link_limit.
[[nodiscard]] std::vector<PackedNode> encode_packed(const KdTree& tree);
/// Parents are found again from the children. InputError where there is no node, or a child is none of the nodes.
[[nodiscard]] KdTree decode_packed(const std::vector<PackedNode>& nodes, std::vector<std::int32_t> references,
                                   const Aabb& bounds);

/// Largest link that 30 bits hold.
inline constexpr std::int64_t packed_link_limit = (std::int64_t(1) << 30) - 1;

/// A node of either kind as walks read it, in which only one of split and count means something; a packed one has no
/// parent to tell.
KD_FN KdNode node_as_read(const TreeNode& n) { return {n.flag, n.split, n.count, n.link, n.parent}; }
KD_FN KdNode node_as_read(const PackedNode& n) {
    return {int(n.kind_and_link & 3), std::bit_cast<float>(n.value), int(n.value), int(n.kind_and_link >> 2), -1};
}

}  // namespace kd
