// kd-tree splits as lines over the image.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/camera.h"
#include "viz/heatmap.h"

namespace kd {

struct OverlayConfig {
    bool show = false;
    int max_depth = 6;            // cells down to this depth
    bool planes = true;           // outlines of split planes
    bool boxes = true;            // outlines of the cells at max_depth (or leaves above it)
    bool hidden_line = true;      // hide what lies behind the surface seen
    float opacity = 0.9f;

    bool operator==(const OverlayConfig&) const = default;
};

/// A segment in world space with the depth of its node (for colour) and the node itself.
struct WorldLine {
    Vec3 a, b;
    int depth;
    int node;
};

/// Outlines of splits and cells down to max_depth; at most `limit` lines, shallowest first.
[[nodiscard]] std::vector<WorldLine> split_lines(const KdTree& tree, const OverlayConfig& config, std::size_t limit = 200000);

/// Outlines of the cells that a ray's walk visits (its leaves and their ancestors' splits), in order.
[[nodiscard]] std::vector<WorldLine> lines_along_ray(const KdTree& tree, const Ray& ray, float t_end);

/// Draws the lines over `image` with a dark one-pixel outline, coloured by depth; hidden where behind `frame`'s primary
/// hit if `hidden_line`. `camera` must be the one the frame was traced with.
void draw_lines(Image<Rgba8>& image, const std::vector<WorldLine>& lines, const PinholeCamera& camera, const Frame& frame,
                const OverlayConfig& config);

} // namespace kd
