#include "viz/figure.h"

#include <algorithm>

namespace kd {

bool needs_oracle(const ViewConfig& view) { return view.show_map && needs_oracle(view.map); }

bool needs_walks(const ViewConfig& view) { return view.show_map && needs_walks(view.map); }

bool needs_visits(const ViewConfig& view) { return view.overlay.show && needs_visits(view.overlay.colour); }

std::optional<CellColours> view_cells(const KdTree& tree, const ViewConfig& view, const BesideFrame& beside) {
    if (!view.overlay.show || view.overlay.colour == CellColour::depth) return std::nullopt;
    return cell_colours(tree, view.overlay.colour, view.overlay.max_depth, view.heat.colormap, beside.visits);
}

std::optional<MapView> view_map(const Frame& frame, const ViewConfig& view, const BesideFrame& beside) {
    if (!view.show_map) return std::nullopt;
    MapView result{compute_map(frame, view.map, beside), {}};
    result.summary = summarise_map(result.map, view.heat);
    return result;
}

Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera, const ViewConfig& view,
                          const std::optional<MapView>& map, const std::optional<CellColours>& cells) {
    Image<Rgba8> image = paint_beauty(frame);
    if (map) {
        // Names are read by their very colours; an image showing through would make others of them.
        const float opacity = map->map.categories.empty() ? view.heat.opacity : 1.0f;
        image = blend(image, paint_map(map->map, view.heat, map->summary.range), opacity);
    }
    if (view.overlay.show) {
        draw_lines(image, split_lines(tree, view.overlay), pinhole(camera, frame.width, frame.height), frame,
                   view.overlay, cells ? std::span<const Rgba8>(cells->of_node) : std::span<const Rgba8>());
    }
    return image;
}

Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera, const ViewConfig& view,
                          const BesideFrame& beside) {
    return make_picture(frame, tree, camera, view, view_map(frame, view, beside), view_cells(tree, view, beside));
}

Image<Rgba8> make_legend(const KdTree& tree, const ViewConfig& view, const std::optional<MapView>& map,
                         const std::optional<CellColours>& cells, const Font& font, int scale) {
    Image<Rgba8> map_legend;
    Image<Rgba8> cell_legend;
    if (map) map_legend = draw_legend(map->map, view.heat, map->summary, font, scale);
    if (cells) {
        cell_legend = draw_legend(cells->scale.map, cells->scale.heat, cells->scale.summary, font, scale);
    } else if (view.overlay.show) {
        const int deepest = std::ranges::max(node_depths(tree));
        cell_legend = draw_depth_legend(view.overlay, deepest, font, scale);
    }
    return stack_images({map_legend, cell_legend}, figure_style::margin * scale);
}

Image<Rgba8> make_figure(const Frame& frame, const KdTree& tree, const Camera& camera, const ViewConfig& view,
                         const std::string& title, const std::string& caption, const Font& font, int scale,
                         const BesideFrame& beside) {
    const std::optional<MapView> map = view_map(frame, view, beside);
    const std::optional<CellColours> cells = view_cells(tree, view, beside);
    return compose_figure(make_picture(frame, tree, camera, view, map, cells),
                          make_legend(tree, view, map, cells, font, scale), title, caption, font, scale);
}

}  // namespace kd
