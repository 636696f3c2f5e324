// VIEW: which number of each pixel is shown, in which colours, and the tree's splits over it.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/widgets.h"
#include "viz/colormap.h"

namespace kd {

namespace {

void draw_map(Edit& edit) {
    const auto all = maps();
    ViewConfig& view = edit.session.view;
    int index = -1;
    for (int i = 0; i < int(all.size()); ++i)
        if (all[std::size_t(i)].name == view.map.map) index = i;
    const auto name = [&](int i) { return std::string(all[std::size_t(i)].name); };
    const auto summary = [&](int i) {
        return fmt::format("{}: {}", all[std::size_t(i)].title, all[std::size_t(i)].summary);
    };
    if (widgets::choice("map", index, int(all.size()), name, summary,
                        "The number that colours stand for. Key M: the next."))
        edits::choose_map(edit, std::string(all[std::size_t(index)].name));
    int rays = int(view.map.rays);
    if (widgets::choice(
            "rays", rays, pass_count, [](int i) { return std::string(ray_names[std::size_t(i)]); },
            [](int i) { return fmt::format("Traced by pass {}.", pass_names[std::size_t(i)]); },
            "Whose counters. A pixel without such rays stays dark."))
        view.map.rays = Pass(rays);
}

void draw_colours(Edit& edit) {
    HeatmapConfig& heat = edit.session.view.heat;
    const auto all = colormaps();
    int index = -1;
    for (int i = 0; i < int(all.size()); ++i)
        if (all[std::size_t(i)].name == heat.colormap) index = i;
    const auto name = [&](int i) { return std::string(all[std::size_t(i)].name); };
    const auto summary = [&](int i) { return std::string(all[std::size_t(i)].summary); };
    if (widgets::choice("colours", index, int(all.size()), name, summary, "Key C: the next."))
        heat.colormap = all[std::size_t(index)].name;
    widgets::slider("opacity", heat.opacity, 0, 1, "%.2f", "Of the colours over the image.");
    widgets::toggle("logarithmic", heat.logarithmic, "Equal steps of colour are equal factors. Key G.");
}

void draw_range(const EngineState& state, Edit& edit) {
    static constexpr const char* names[] = {"automatic", "fixed", "locked"};
    static constexpr const char* summaries[] = {
        "Follows the picture: up to the value that 99.5 % of the pixels stay below. Key N.",
        "From the two numbers below.", "Keeps the range as it is now, so that pictures can be compared. Key L."};
    HeatmapConfig& heat = edit.session.view.heat;
    int mode = int(heat.range_mode);
    if (widgets::choice(
            "range", mode, 3, [](int i) { return std::string(names[i]); },
            [](int i) { return std::string(summaries[i]); }, "Values at the two ends of the colours.")) {
        edits::lock_range(state, edit, RangeMode(mode) != RangeMode::automatic);
        heat.range_mode = RangeMode(mode);
    }
    if (heat.range_mode != RangeMode::fixed) return;
    const float top = std::max(
        {100.0f, heat.range_max * 2, state.picture && state.picture->map ? state.picture->map->summary.max : 0});
    widgets::slider("from", heat.range_min, 0, top, "%.4g", "Values below are clipped; the legend counts them.");
    widgets::slider("to", heat.range_max, 0, top, "%.4g", "Values above are clipped; the legend counts them.");
    if (!(heat.range_max > heat.range_min)) heat.range_max = std::nextafter(heat.range_min, INFINITY);
}

void draw_tiles(MapConfig& map) {
    widgets::slider("group width", map.tile_width, 1, 64, "%d px", "Pixels side by side that run in lockstep.");
    widgets::slider("group height", map.tile_height, 1, 64, "%d px",
                    "Pixels below each other that run in lockstep. 8 × 4 is a warp of 32.");
    // A group has 4 to 1024 lanes.
    map.tile_height =
        std::clamp(map.tile_height, (3 + map.tile_width) / map.tile_width, std::max(1, 1024 / map.tile_width));
}

void draw_splits(OverlayConfig& overlay) {
    widgets::toggle("splits", overlay.show,
                    "Draws the tree over the image: cells, and the planes that cut them. Key S.");
    if (!overlay.show) return;
    widgets::slider("to depth", overlay.max_depth, 0, 24, "%d", "Splits below this depth are not drawn. Keys [ and ].");
    widgets::toggle("planes", overlay.planes, "Outlines of the split planes.");
    widgets::toggle("cells", overlay.boxes, "Outlines of the cells at that depth, and of leaves above it.");
    widgets::toggle("hide behind", overlay.hidden_line,
                    "Hides what lies behind the surface seen; off: shows it faintly.");
    widgets::slider("line opacity", overlay.opacity, 0.1f, 1, "%.2f", "Of the lines.");
}

}  // namespace

void draw_view_panel(const EngineState& state, Edit& edit) {
    ViewConfig& view = edit.session.view;
    widgets::toggle("show map", view.show_map, "Colours over the image. Key H.");
    if (view.show_map) {
        ImGui::PushID("map");
        draw_map(edit);
        const MapInfo* map = find_map(view.map.map);
        if (map && map->over_tiles()) draw_tiles(view.map);
        draw_colours(edit);
        draw_range(state, edit);
        ImGui::PopID();
    }
    draw_splits(view.overlay);
    widgets::toggle("legend", edit.window.legend, "The legend over the picture.");
}

}  // namespace kd
