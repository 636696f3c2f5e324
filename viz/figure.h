// The picture that window, export and gallery show: beauty, map, splits, legend. A function of its arguments alone.
#pragma once

#include <optional>
#include <string>

#include "viz/legend.h"
#include "viz/view_config.h"

namespace kd {

/// A map with the numbers about it that colours and legend need.
struct MapView {
    ScalarMap map;
    MapSummary summary;
};

/// The map that `view` shows; nothing where it shows none. InputError as compute_map and get_colormap.
[[nodiscard]] std::optional<MapView> view_map(const Frame& frame, const ViewConfig& view);

/// The frame's colours, `map` over them, and the tree's splits over both. `camera` is the frame's.
[[nodiscard]] Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera,
                                        const ViewConfig& view, const std::optional<MapView>& map);
/// The same with view_map(frame, view).
[[nodiscard]] Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera,
                                        const ViewConfig& view);

/// Legends of what `view` shows, below each other; an empty image where there is nothing to explain.
[[nodiscard]] Image<Rgba8> make_legend(const KdTree& tree, const ViewConfig& view, const std::optional<MapView>& map,
                                       const Font& font, int scale = 1);

/// Picture, legends, title and caption in one image.
[[nodiscard]] Image<Rgba8> make_figure(const Frame& frame, const KdTree& tree, const Camera& camera,
                                       const ViewConfig& view, const std::string& title, const std::string& caption,
                                       const Font& font, int scale = 1);

}  // namespace kd
