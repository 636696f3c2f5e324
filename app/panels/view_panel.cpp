// VIEW: which number of each pixel is shown, in which colours, and the tree's splits over it.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/colormap.h"

namespace kd {

namespace {

/// What lies over the image, side by side.
void draw_layers(Edit& edit) {
    const float third = ImGui::GetContentRegionAvail().x / 3;
    const float left = ImGui::GetCursorPosX();
    ViewConfig& view = edit.session.view;
    widgets::check("map", view.show_map, "Colours over the image. Key H.");
    ImGui::SameLine(left + third);
    widgets::check("splits", view.overlay.show,
                   "The tree over the image: cells, and the planes that cut them. Key S. Option --overlay.");
    ImGui::SameLine(left + 2 * third);
    widgets::check("legend", edit.window.legend, "The legend over the picture; drag it to another corner. Key K.");
}

void draw_map(const EngineState& state, Edit& edit) {
    ViewConfig& view = edit.session.view;
    std::string map = view.map.map;
    if (widgets::choice("map", map, widgets::options_of(maps()),
                        "The number that colours stand for. Key M: the next. Option --map."))
        edits::show_map(edit, map);
    int index = int(view.map.rays);
    if (widgets::choice("rays", index, ray_options(state, edit.session.trace),
                        "Whose counters. A pixel without such rays stays dark. Option --rays."))
        view.map.rays = Pass(index);
    // Chosen for another scene or setting, and kept for when they are there again.
    const std::string none = why_absent(state, edit.session.trace, view.map.rays);
    if (!none.empty()) widgets::note(fmt::format("No {} rays: {}.", ray_names[std::size_t(view.map.rays)], none));
}

void draw_range(const EngineState& state, Edit& edit) {
    HeatmapConfig& heat = edit.session.view.heat;
    int mode = int(heat.range_mode);
    if (widgets::choice(
            "range", mode,
            {{"automatic", "Follows the picture: up to the value that 99.5 % of the pixels stay below. Key N."},
             {"fixed", "From the two numbers below."},
             {"locked", "Keeps the range as it is now, so that pictures can be compared. Key L."}},
            "Values at the two ends of the colours.")) {
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

void draw_tiles(Edit& edit) {
    MapConfig& map = edit.session.view.map;
    widgets::slider("group width", map.tile_width, 1, 64, "%d px", "Pixels side by side that run in lockstep.");
    widgets::slider("group height", map.tile_height, 1, 64, "%d px",
                    "Pixels below each other that run in lockstep. 8 × 4 is a warp of 32.");
    std::vector<widgets::Option> loops;
    for (const ScheduleInfo& schedule : schedules())
        loops.push_back({std::string(schedule.name), std::string(schedule.summary)});
    int schedule = int(map.schedule);
    if (widgets::choice("schedule", schedule, loops, "How a group shares its steps. Option --schedule."))
        map.schedule = Schedule(schedule);
    if (widgets::button("efficiency against width",
                        "At the bottom: what wider and wider groups lose. Again: times. Key Shift D."))
        edits::switch_bottom(edit, divergence_panel);
    // A group has 4 to 1024 lanes.
    map.tile_height =
        std::clamp(map.tile_height, (3 + map.tile_width) / map.tile_width, std::max(1, 1024 / map.tile_width));
}

void draw_split_depth(OverlayConfig& overlay) {
    if (widgets::slider("splits to depth", overlay.max_depth, 0, 24, "%d",
                        "Splits below this depth are not drawn. Keys [ and ]. Option --overlay-depth."))
        overlay.show = true;
}

/// What the lines' colours say. Counted visits need walks through a tree.
void draw_cell_colours(Edit& edit) {
    OverlayConfig& overlay = edit.session.view.overlay;
    std::vector<widgets::Option> options;
    for (const CellColourInfo& colour : all_cell_colours()) {
        options.push_back({std::string(colour.name), std::string(colour.summary)});
        if (needs_visits(colour.id) && edit.session.trace.traversal == Traversal::naive)
            options.back().missing = "the loop over all triangles visits no cells";
    }
    int chosen = int(overlay.colour);
    if (widgets::choice("split colours", chosen, options,
                        "What the colours of the splits say. Visits are those of the rays above, counted when nobody "
                        "works. Option --overlay-colour.")) {
        overlay.colour = CellColour(chosen);
        overlay.show = true;
    }
}

/// Why the map chosen has no logarithmic scale; empty where it can have one.
std::string no_log(const Edit& edit) {
    if (edits::takes_log(edit)) return "";
    const MapInfo* map = find_map(edit.session.view.map.map);
    return map && map->kind == MapInfo::Kind::category ? "This map shows names, which have no scale."
                                                       : "This map is a share from 0 to 1: its scale is linear.";
}

void draw_colours(Edit& edit) {
    HeatmapConfig& heat = edit.session.view.heat;
    widgets::choice("colours", heat.colormap, widgets::options_of(colormaps()), "Key C: the next. Option --colormap.");
    const MapInfo* map = find_map(edit.session.view.map.map);
    const bool names = map && map->kind == MapInfo::Kind::category;
    ImGui::BeginDisabled(names);
    widgets::slider("opacity", heat.opacity, 0, 1, "%.2f",
                    names ? "This map shows names: their colours cover the image."
                          : "Of the colours over the image. Option --opacity.");
    ImGui::EndDisabled();
    const std::string why_not = no_log(edit);
    bool logarithmic = heat.logarithmic;
    ImGui::BeginDisabled(!why_not.empty());
    if (widgets::toggle("logarithmic", logarithmic,
                        why_not.empty() ? "Equal steps of colour are equal factors. Key G. Option --log." : why_not))
        edits::toggle_log(edit);
    ImGui::EndDisabled();
}

void draw_split_lines(Edit& edit) {
    if (!widgets::fold("split lines", ImGui::GetIO().DisplaySize.y >= theme::px(1200))) return;
    OverlayConfig& overlay = edit.session.view.overlay;
    draw_cell_colours(edit);
    widgets::toggle("planes", overlay.planes, "Outlines of the split planes.");
    widgets::toggle("cells", overlay.boxes, "Outlines of the cells at that depth, and of leaves above it.");
    widgets::toggle("hide behind", overlay.hidden_line,
                    "Hides what lies behind the surface seen; off: shows it faintly.");
    widgets::slider("line opacity", overlay.opacity, 0.1f, 1, "%.2f", "Of the lines.");
}

}  // namespace

void draw_view_panel(const EngineState& state, Edit& edit) {
    ViewConfig& view = edit.session.view;
    draw_layers(edit);
    draw_map(state, edit);
    draw_range(state, edit);
    draw_split_depth(view.overlay);
    const MapInfo* map = find_map(view.map.map);
    if (map && map->over_tiles()) draw_tiles(edit);
    draw_colours(edit);
    draw_split_lines(edit);
}

}  // namespace kd
