// kd-tree splits as lines over the image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/camera.h"
#include "renderer/trace/frame.h"
#include "viz/text.h"

namespace kd {

/// What the colour of a cell's lines says.
enum class CellColour {
    depth,      // of its node
    visits,     // how often rays came by, counted
    predicted,  // how often they should, by its surface area: the surface area heuristic's assumption
    ratio,      // counted over predicted
};

struct OverlayConfig {
    bool show = false;
    CellColour colour = CellColour::depth;
    int max_depth = 6;        // cells down to this depth
    bool planes = true;       // outlines of split planes
    bool boxes = true;        // outlines of the cells at max_depth (or leaves above it)
    bool hidden_line = true;  // hide what lies behind the surface seen; otherwise it shows faintly
    float opacity = 0.9f;

    bool operator==(const OverlayConfig&) const = default;
};

/// A segment in world space with the depth of its node (for colour) and the node itself.
struct WorldLine {
    Vec3 a, b;
    int depth;
    int node;
};

/// Outlines of splits and cells down to max_depth; at most `limit` lines, shallowest first. Each node's outline is
/// whole or absent.
[[nodiscard]] std::vector<WorldLine> split_lines(const KdTree& tree, const OverlayConfig& config,
                                                 std::size_t limit = 200000);

/// Outlines of the leaves that a ray meets up to `t_end`, in order, each after the splits above it that are not shown
/// yet.
[[nodiscard]] std::vector<WorldLine> lines_along_ray(const KdTree& tree, const Ray& ray, float t_end);

/// Two ends of a line over the picture, in pixels from its top left corner, with the depth of its node.
struct ScreenLine {
    float x0, y0, x1, y1;
    int depth;
};

/// lines_along_ray() of the primary ray through pixel (x, y) of a width x height picture up to its hit, as far as they
/// lie in the picture; `most` lines, those met first.
[[nodiscard]] std::vector<ScreenLine> ray_cells(const KdTree& tree, const PinholeCamera& camera, int width, int height,
                                                int x, int y, const Hit& hit, std::size_t most = 4000);

/// A leaf that a ray visits, and from where to where along the ray it lies: no numbers (NaN) where the ray passes it
/// by, within the slack of robust walks.
struct RayLeaf {
    int node = 0;
    int depth = 0;
    float enters = 0, leaves = 0;
    std::vector<ScreenLine> outline;  // in a picture
};

/// The leaf `node` on the primary ray through pixel (x, y) of a width x height picture that ends at its hit.
[[nodiscard]] RayLeaf leaf_on_ray(const KdTree& tree, int node, const PinholeCamera& camera, int width, int height,
                                  int x, int y, const Hit& hit);

/// Draws the lines over `image` with a dark one-pixel outline, each in the colour of its node, or by depth where
/// `of_node` is empty; where behind `frame`'s primary hit they are left out if `hidden_line` and faint otherwise.
/// `camera` must be the one the frame was traced with, and `image` and `frame` of one size. Where lines cross, the one
/// nearer the start of the list is on top.
void draw_lines(Image<Rgba8>& image, const std::vector<WorldLine>& lines, const PinholeCamera& camera,
                const Frame& frame, const OverlayConfig& config, std::span<const Rgba8> of_node = {});

/// Colour of lines at `depth`: pale yellow at the root to purple at max_depth and below.
[[nodiscard]] Rgba8 depth_colour(int depth, int max_depth);

/// What the colours mean: a swatch for each depth from 0 to the deepest shown.
[[nodiscard]] Image<Rgba8> draw_depth_legend(const OverlayConfig& config, int deepest, const Font& font, int scale = 1);

}  // namespace kd
