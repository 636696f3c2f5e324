#include "renderer/kdtree/encode.h"

#include <cmath>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

float exact_float(std::size_t node, const char* what, std::int64_t number) {
    if (std::abs(number) > float_index_limit) {
        throw InputError(fmt::format("node {}: {} {} is beyond {}, the largest a float texel holds exactly; build a "
                                     "smaller tree: a lower --max-depth or --reference-cap, or a larger --leaf-size",
                                     node, what, number, float_index_limit));
    }
    return float(number);
}

std::int32_t exact_integer(std::size_t node, const char* what, float number) {
    const float limit = float(float_index_limit);
    if (!(std::abs(number) <= limit) || number != std::trunc(number)) {
        throw InputError(
            fmt::format("texel {}: {} {} is not a whole number within +-{}: the texture does not hold a tree", node,
                        what, number, float_index_limit));
    }
    return std::int32_t(number);
}

std::uint32_t in_30_bits(std::size_t node, std::int32_t link) {
    if (link < 0 || link > packed_link_limit)
        throw InputError(fmt::format("node {}: link {} is not within 0 to {}, the most that 30 bits hold; use nodes of "
                                     "16 bytes, or build a smaller tree: a lower --max-depth or --reference-cap, or a "
                                     "larger --leaf-size",
                                     node, link, packed_link_limit));
    return std::uint32_t(link);
}

/// `child` gets to know that it is one. Links lead upwards only, so no node is its own child.
void adopt(std::vector<TreeNode>& nodes, std::size_t parent, std::size_t child) {
    if (child <= parent || child >= nodes.size())
        throw InputError(fmt::format("node {}: child {} does not stand behind it among {} nodes: they are no tree",
                                     parent, child, nodes.size()));
    nodes[child].parent = std::int32_t(parent);
}

}  // namespace

std::vector<Vec4> encode_float4(const KdTree& tree) {
    std::vector<Vec4> texels;
    texels.reserve(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const float value = node.is_leaf() ? exact_float(i, "count", node.count) : node.split;
        texels.emplace_back(float(node.flag), value, exact_float(i, "link", node.link),
                            exact_float(i, "parent", node.parent));
    }
    return texels;
}

KdTree decode_float4(const std::vector<Vec4>& texels, std::vector<std::int32_t> references, const Aabb& bounds) {
    if (texels.empty()) throw InputError("tree texture is empty: a tree has at least one node");
    KdTree tree;
    tree.nodes.clear();
    tree.nodes.reserve(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const Vec4& texel = texels[i];
        TreeNode& node = tree.nodes.emplace_back();
        node.flag = exact_integer(i, "flag", texel.x);
        if (node.flag < 0 || node.flag > KD_LEAF) {
            throw InputError(
                fmt::format("texel {}: flag {} is none of 0, 1, 2 (split axis) and 3 (leaf): the texture does "
                            "not hold a tree",
                            i, node.flag));
        }
        if (node.is_leaf())
            node.count = exact_integer(i, "count", texel.y);
        else
            node.split = texel.y;
        node.link = exact_integer(i, "link", texel.z);
        node.parent = exact_integer(i, "parent", texel.w);
    }
    tree.references = std::move(references);
    tree.bounds = bounds;
    return tree;
}

std::vector<PackedNode> encode_packed(const KdTree& tree) {
    std::vector<PackedNode> packed(tree.nodes.size());
    for (std::size_t i = 0; i < packed.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        packed[i].value = node.is_leaf() ? std::uint32_t(node.count) : std::bit_cast<std::uint32_t>(node.split);
        packed[i].kind_and_link = std::uint32_t(node.flag) | in_30_bits(i, node.link) << 2;
    }
    return packed;
}

KdTree decode_packed(const std::vector<PackedNode>& nodes, std::vector<std::int32_t> references, const Aabb& bounds) {
    if (nodes.empty()) throw InputError("there are no packed nodes: a tree has at least one");
    KdTree tree;
    tree.nodes.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const KdNode read = node_as_read(nodes[i]);
        TreeNode& node = tree.nodes[i];
        node.flag = read.flag;
        node.link = read.link;
        if (node.is_leaf()) {
            node.count = read.count;
            continue;
        }
        node.split = read.split;
        adopt(tree.nodes, i, i + 1);
        adopt(tree.nodes, i, std::size_t(read.link));
    }
    tree.references = std::move(references);
    tree.bounds = bounds;
    return tree;
}

}  // namespace kd
