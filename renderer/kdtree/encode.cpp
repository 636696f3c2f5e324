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

}  // namespace kd
