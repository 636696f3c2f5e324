// PIXEL: everything about one pixel in numbers, the pinned one or the one under the mouse. Its rows always stand where
// they are, so that nothing jumps while the mouse comes and goes.
#include <cmath>
#include <fmt/format.h>

#include "app/engine/pixel.h"
#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/panels/verdict_rows.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/counters.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr const char* none = "–";

/// In how many leaves a ray may meet the triangle that the pinned pixel's ray hit.
std::string leaves_text(const EngineState& state, const PassReading& ray) {
    if (!state.hit || !state.pinned || state.hit->triangle != ray.hit.triangle) return "";
    const std::size_t leaves = state.hit->leaves.size();
    return fmt::format(" in {} {}", number_text(double(leaves)), leaves == 1 ? "leaf" : "leaves");
}

void draw_hit(const EngineState& state, const PassReading& ray) {
    const bool hit = ray.hit.triangle >= 0;
    const std::string missed = ray.traced ? "none" : none;
    widgets::value("triangle", hit ? fmt::format("#{}{}", ray.hit.triangle, leaves_text(state, ray)) : missed,
                   "Number of the triangle that the ray hit first; where the pixel is pinned, also how many leaves of "
                   "the tree list it. NODES (key I) ticks them.");
    widgets::value("distance t", hit ? number_text(double(ray.distance)) : none,
                   "From the ray's origin to the hit, in scene units.");
    widgets::value("u, v", hit ? fmt::format("{:.3f}, {:.3f}", ray.hit.u, ray.hit.v) : none,
                   "Barycentric coordinates in the triangle.");
    widgets::value("ended by", ray.traced ? std::string(exit_reason_name(ray.counters.exit_reason)) : none,
                   "Hit and miss are answers; anything else means that the ray was given up.",
                   ray.traced && ray.counters.exit_reason > uint(KD_EXIT_HIT) ? theme::error : 0);
}

void draw_counters(const PassReading& ray) {
    const RayCounters& c = ray.counters;
    const auto count = [&](const char* label, uint number, std::string_view tooltip) {
        widgets::value(label, ray.traced ? number_text(number) : none, tooltip);
    };
    count("interior nodes", c.interior_first + c.interior_again, "Visits of interior nodes, repeated ones included.");
    count("  of these again", c.interior_again, "Visits beyond the first: the price of having no stack.");
    count("leaves", c.leaves, "Leaf cells that the ray passed, empty ones included.");
    count("triangle tests", c.triangle_tests, "Ray-triangle tests.");
    count("restarts", c.restarts, "Returns to the root (kd-restart).");
    count("backtracks", c.backtracks, "Climbs from a leaf to find the next one (kd-backtrack).");
    count("deepest stack", c.stack_depth, "Most far children that waited at one time.");
}

/// The leaves that the primary ray of the pinned pixel visits, and the one that a person stepped to.
void draw_step(const EngineState& state, Edit& edit) {
    const std::optional<StepReading>& step = state.step;
    const int count = state.pinned ? int(state.pinned->primary().counters.leaves) : 0;
    widgets::begin_row("leaf",
                       "Keys . and , step through the leaves that the pinned pixel's primary ray visits, in its "
                       "order; the leaf is drawn over the picture.");
    if (widgets::button("<", "The leaf before it. Key ,", step.has_value(), 0)) edits::step_ray(state, edit, -1);
    ImGui::SameLine();
    const bool more = count > 0 && (!step || step->number + 1 < step->count);
    if (widgets::button(">", "The next leaf of the walk. Key .", more, 0)) edits::step_ray(state, edit, 1);
    ImGui::SameLine();
    ImGui::TextUnformatted(step        ? fmt::format("{} of {}", step->number + 1, step->count).c_str()
                           : count > 0 ? fmt::format("{} of {}", none, count).c_str()
                                       : none);
    if (!step) return;
    const std::string part = std::isnan(step->leaf.enters) ? "beside it"
                                                           : fmt::format("{}, {}", number_text(step->leaf.enters),
                                                                         number_text(step->leaf.leaves));
    widgets::value(
        "  from t, to", part,
        "Where the ray enters the leaf and leaves it, or ends; in scene units. Beside it: the ray passes the "
        "leaf by so closely that robust rules look into it.");
    widgets::value("  depth, triangles", fmt::format("{}, {}", step->leaf.depth, step->triangles),
                   "Of the leaf: the splits above it, and the triangles in its list.");
}

/// Whose walk is read: the map's rays unless one kind is chosen.
void draw_rays(const EngineState& state, Edit& edit) {
    const std::string shown(ray_names[std::size_t(edit.session.view.map.rays)]);
    std::vector<widgets::Option> options = ray_options(state, edit.session.trace);
    options.insert(options.begin(), widgets::Option{"the map's", "Those that VIEW shows: " + shown + "."});
    int index = edit.window.pixel_rays ? 1 + int(*edit.window.pixel_rays) : 0;
    if (!widgets::choice("rays", index, options,
                         "Whose numbers stand here. Counters are sums over a pixel's lights or bounces; the hit is the "
                         "first occluder, or that of the first bounce."))
        return;
    edit.window.pixel_rays = index == 0 ? std::nullopt : std::optional(Pass(index - 1));
}

/// One line for each of the other kinds of rays that there are in the picture.
void draw_other_rays(const EngineState& state, const Edit& edit, const PixelReading& reading, Pass read) {
    widgets::heading("other rays: nodes, tests");
    for (std::size_t p = 0; p < pass_count; ++p) {
        if (Pass(p) == read || !why_absent(state, edit.session.trace, Pass(p)).empty()) continue;
        const PassReading& ray = reading.passes[p];
        const RayCounters& c = ray.counters;
        widgets::value(ray_names[p].data(),
                       ray.traced ? fmt::format("{}, {}", number_text(c.interior_first + c.interior_again),
                                                number_text(c.triangle_tests))
                                  : none,
                       "Interior visits and triangle tests, summed over lights or bounces.");
    }
}

void draw_position(const std::optional<PixelReading>& reading, bool pinned) {
    std::string text = none;
    if (reading) text = fmt::format("{}{}, {}", reading->scale > 1 ? "≈ " : "", reading->pixel.x, reading->pixel.y);
    widgets::value(
        "pixel", text,
        "Column and row, from the top left corner. ≈: the numbers are of a coarse picture's pixel that covers "
        "this one, until the whole picture is there.",
        pinned ? theme::selected : 0);
}

/// The value of a map that no counter below tells: those of groups of pixels and of whole walks.
void draw_map_value(const EngineState& state, const std::optional<PixelReading>& reading) {
    if (!state.picture || !state.picture->map) return;
    const MapInfo* map = find_map(state.picture->view.map.map);
    if (!map || map->of_pixel || map->needs_oracle()) return;
    const std::optional<float> value = reading ? read_map(*state.picture, reading->pixel) : std::nullopt;
    widgets::value(
        map->name.data(), value ? number_text(double(*value)) : none,
        fmt::format("The map's value here: {}{}{}.", map->title, map->unit.empty() ? "" : ", in ", map->unit));
}

}  // namespace

void draw_pixel_panel(const EngineState& state, Edit& edit) {
    const std::optional<PixelReading>& found = state.pinned ? state.pinned : state.hovered;
    const PixelReading reading = found.value_or(PixelReading{});
    draw_position(found, state.pinned.has_value());
    draw_map_value(state, found);
    draw_rays(state, edit);
    draw_step(state, edit);
    const Pass read = rays_read(edit);
    const PassReading& ray = reading.passes[std::size_t(read)];
    // Close together, so that EXPORT below them is to be seen in a window 720 pixels high.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, theme::px(2)});
    draw_hit(state, ray);
    draw_verdict(state, edit);
    widgets::heading(fmt::format("walk of the {} rays", ray_names[std::size_t(read)]).c_str());
    draw_counters(ray);
    draw_other_rays(state, edit, reading, read);
    ImGui::PopStyleVar();
    const bool held = edit.window.pinned || edit.window.node || edit.window.triangle;
    if (widgets::button("release pixel",
                        held ? "Follows the mouse again, and no node is selected. Key Esc."
                             : "Move the mouse over the picture to read a pixel; click there to keep it.",
                        held))
        edits::release(edit);
}

}  // namespace kd
