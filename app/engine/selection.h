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
    static constexpr std::size_t most_outlined = 64;  // more would hide the picture

    std::string path;  // from the root (renderer/kdtree/hand_split.h)
    int node = 0;
    int depth = 0;
    Aabb cell;
    double share = 1;                 // of the root's surface: the chance that a uniform line which meets that meets it
    std::vector<ScreenLine> outline;  // of the cell, in the picture
    std::shared_ptr<const std::vector<int>> triangles;  // in the leaves below it, ascending, each once
    std::vector<ScreenLine> triangle_outlines;          // in the picture; none where there are more than most_outlined
};

/// Without its triangles. Nothing where the tree ends before the path.
[[nodiscard]] std::optional<NodeSelection> select_node(const KdTree& tree, const std::string& path,
                                                       const PictureView& view);

/// One triangle, in all views: one clicked on, else what the primary ray of the pinned pixel hit, else of the pixel
/// under the mouse. Lengths in the units of the tree.
struct HitSelection {
    int triangle = -1;
    bool has_ray = false;                // of a pixel, rather than clicked on
    int leaf = -1;                       // in which the pinned pixel's ray found it; -1 of any other
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
