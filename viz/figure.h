// The picture that window, export and gallery show: beauty, map, splits, legend. A function of its arguments alone.
#pragma once

#include <optional>
#include <string>

#include "viz/cell_colours.h"
#include "viz/legend.h"
#include "viz/view_config.h"

namespace kd {

/// A map with the numbers about it that colours and legend need.
struct MapView {
    ScalarMap map;
    MapSummary summary;
};

/// True where the map that `view` shows compares the rays' hits with exact ones.
[[nodiscard]] bool needs_oracle(const ViewConfig& view);

/// True where the map that `view` shows is made from the walks of groups of rays.
[[nodiscard]] bool needs_walks(const ViewConfig& view);

/// True where the cells that `view` shows are coloured by counted visits.
[[nodiscard]] bool needs_visits(const ViewConfig& view);

/// The map that `view` shows; nothing where it shows none. InputError and `beside` as compute_map; get_colormap.
[[nodiscard]] std::optional<MapView> view_map(const Frame& frame, const ViewConfig& view,
                                              const BesideFrame& beside = {});

/// The colours of the cells that `view` shows; nothing where it shows none, or colours them by depth.
[[nodiscard]] std::optional<CellColours> view_cells(const KdTree& tree, const ViewConfig& view,
                                                    const BesideFrame& beside = {});

/// The frame's colours, `map` over them, and the tree's splits over both, in the colours of `cells`. `camera` is the
/// frame's.
[[nodiscard]] Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera,
                                        const ViewConfig& view, const std::optional<MapView>& map,
                                        const std::optional<CellColours>& cells);
/// The same with view_map() and view_cells().
[[nodiscard]] Image<Rgba8> make_picture(const Frame& frame, const KdTree& tree, const Camera& camera,
                                        const ViewConfig& view, const BesideFrame& beside = {});

/// Legends of what `view` shows, below each other; an empty image where there is nothing to explain.
[[nodiscard]] Image<Rgba8> make_legend(const KdTree& tree, const ViewConfig& view, const std::optional<MapView>& map,
                                       const std::optional<CellColours>& cells, const Font& font, int scale = 1);

/// Picture, legends, title and caption in one image.
[[nodiscard]] Image<Rgba8> make_figure(const Frame& frame, const KdTree& tree, const Camera& camera,
                                       const ViewConfig& view, const std::string& title, const std::string& caption,
                                       const Font& font, int scale = 1, const BesideFrame& beside = {});

}  // namespace kd
