// Planes that a person puts where a builder would have put others.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kd {

struct KdTree;  // renderer/kdtree/tree.h

/// Steps from the root in a path: to the child below a split, and to the one above it.
inline constexpr char path_below = 'b', path_above = 'a';

/// One plane, for the node at the end of a path. It is used where that node is reached, holds triangles and has the
/// plane strictly inside its cell; BuildReport::idle_hand_splits counts those that are not.
struct HandSplit {
    std::string path;  // "" is the root
    int axis = 0;
    float position = 0;  // in the units of the triangles that the tree is built from

    bool operator==(const HandSplit&) const = default;
};

/// What is wrong with one of these, whatever the tree: "axis 3 is none of 0, 1, 2"; of two for one node it is the
/// second. Nothing where it can be used.
[[nodiscard]] std::optional<std::string> hand_split_fault(std::span<const HandSplit> splits, std::size_t which);

/// The path from the root to a node.
[[nodiscard]] std::string node_path(const KdTree& tree, int node);

/// The node at the end of a path; nothing where the tree ends before, or where a step is neither of the two.
[[nodiscard]] std::optional<int> node_at(const KdTree& tree, std::string_view path);

/// Why a plane is not used in a tree that was built with it, such as "the tree ends above its node"; nothing where it
/// is.
[[nodiscard]] std::optional<std::string> why_idle(const KdTree& tree, const HandSplit& split);

}  // namespace kd
