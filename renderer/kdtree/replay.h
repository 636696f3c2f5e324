// One cell as the build of a tree met it: for asking builders about it once the tree is finished.
#pragma once

#include <optional>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/split.h"

namespace kd {

/// A split on the way from the root to a node, and the child taken.
struct WayStep {
    Split split;
    bool above = false;
};

/// The way to a node. A tree does not keep on which side triangles lying in a plane went: below, so far.
[[nodiscard]] std::vector<WayStep> way_to(const KdTree& tree, int node);

/// Looks up on which side they went: goes the way with the builder of the task and asks it again where it names the
/// same planes. Takes as long as all those decisions took; `bounds` are the tree's.
void learn_planar_sides(const BuildTask& task, const Aabb& bounds, std::vector<WayStep>& way);

/// Where the builder of the task splits the cell at the end of the way, at first hand: before limits of depth,
/// references and bad refines, and without planes by hand. Nothing where it makes a leaf.
[[nodiscard]] std::optional<Split> choice_at_end(const BuildTask& task, const Aabb& bounds,
                                                 const std::vector<WayStep>& way);

}  // namespace kd
