// What is selected of the tree, in all views: one node, and what the pinned pixel's ray hit.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/engine/world.h"
#include "viz/overlay.h"

namespace kd {

/// A picture that something lies in: the camera it was traced with, and its size.
struct PictureView {
    PinholeCamera camera;
    int width = 0, height = 0;
};

/// Lengths in the units of the tree.
struct NodeSelection {
    std::string path;  // from the root (renderer/kdtree/hand_split.h)
    int node = 0;
    int depth = 0;
    Aabb cell;
    double share = 1;                 // of the root's surface: the chance that a uniform line which meets that meets it
    std::vector<ScreenLine> outline;  // of the cell, in the picture
};

/// Nothing where the tree ends before the path.
[[nodiscard]] std::optional<NodeSelection> select_node(const KdTree& tree, const std::string& path,
                                                       const PictureView& view);

/// What the pinned pixel's primary ray hit; lengths in the units of the tree.
struct HitSelection {
    int triangle = -1;
    int leaf = -1;                       // in which it was found
    std::vector<int> leaves;             // all that list the triangle, ascending
    std::shared_ptr<const World> world;  // whose nodes these are
    Vec3 from{}, to{};                   // the ray, from the eye to the hit
    std::vector<ScreenLine> outline;     // of the triangle, in the picture
};

/// The leaves whose lists name the triangle.
[[nodiscard]] std::vector<int> leaves_with(const KdTree& tree, int triangle);

/// The edges of a triangle in the picture.
[[nodiscard]] std::vector<ScreenLine> triangle_outline(const Triangle& triangle, const PictureView& view);

}  // namespace kd
