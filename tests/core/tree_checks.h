// Questions that several tests ask of a tree.
#pragma once

#include <algorithm>
#include <string>

#include "renderer/kdtree/validate.h"

namespace kd::test {

/// Findings of the validator as text; empty for a sound tree.
[[nodiscard]] inline std::string faults(const KdTree& tree, std::span<const Triangle> triangles) {
    std::string all;
    for (const Violation& v : validate(tree, triangles)) {
        all += "node " + std::to_string(v.node) + ": " + v.message + "\n";
    }
    return all;
}

[[nodiscard]] inline int depth_of(const KdTree& tree) {
    const std::vector<int> depths = node_depths(tree);
    return *std::max_element(depths.begin(), depths.end());
}

}  // namespace kd::test
