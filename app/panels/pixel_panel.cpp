// PIXEL: everything about one pixel in numbers, the pinned one or the one under the mouse.
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/counters.h"
#include "viz/numbers.h"

namespace kd {

namespace {

void draw_hit(const PassReading& ray) {
    const bool hit = ray.hit.triangle >= 0;
    widgets::value("triangle", hit ? fmt::format("#{}", ray.hit.triangle) : "none",
                   "Number of the triangle that the ray hit first.");
    widgets::value("distance t", hit ? number_text(double(ray.hit.t)) : "–",
                   "From the eye to the hit, in scene units.");
    widgets::value("u, v", hit ? fmt::format("{:.3f}, {:.3f}", ray.hit.u, ray.hit.v) : "–",
                   "Barycentric coordinates in the triangle.");
    widgets::value("ended by", std::string(exit_reason_name(ray.counters.exit_reason)),
                   "Hit and miss are answers; anything else means that the ray was given up.",
                   ray.counters.exit_reason > uint(KD_EXIT_HIT) ? theme::error : 0);
}

void draw_counters(const PassReading& ray) {
    const RayCounters& c = ray.counters;
    const uint nodes = c.interior_first + c.interior_again;
    widgets::value("interior nodes", number_text(nodes), "Visits of interior nodes, repeated ones included.");
    widgets::value("  of these again", number_text(c.interior_again),
                   "Visits beyond the first: the price of having no stack.");
    widgets::value("leaves", number_text(c.leaves), "Leaf cells that the ray passed, empty ones included.");
    widgets::value("triangle tests", number_text(c.triangle_tests), "Ray-triangle tests.");
    widgets::value("restarts", number_text(c.restarts), "Returns to the root (kd-restart).");
    widgets::value("climbs", number_text(c.backtracks), "Climbs from a leaf (kd-backtrack).");
    widgets::value("deepest stack", number_text(c.stack_depth), "Most far children that waited at one time.");
}

/// One line for each other kind of rays at this pixel.
void draw_other_rays(const PixelReading& reading) {
    bool any = false;
    for (std::size_t p = 1; p < pass_count; ++p) any = any || reading.passes[p].traced;
    if (!any) return;
    widgets::heading("other rays: nodes, tests");
    for (std::size_t p = 1; p < pass_count; ++p) {
        const PassReading& ray = reading.passes[p];
        if (!ray.traced) continue;
        widgets::value(ray_names[p].data(),
                       fmt::format("{}, {}", number_text(ray.counters.interior_first + ray.counters.interior_again),
                                   number_text(ray.counters.triangle_tests)),
                       "Interior visits and triangle tests, summed over lights or bounces.");
    }
}

}  // namespace

void draw_pixel_panel(const EngineState& state, Edit& edit) {
    const std::optional<PixelReading>& reading = state.pinned ? state.pinned : state.hovered;
    if (!reading) {
        widgets::note("Move the mouse over the picture to read a pixel; click to keep it.");
        return;
    }
    const bool pinned = state.pinned.has_value();
    widgets::value("pixel", fmt::format("{}, {}", reading->pixel.x, reading->pixel.y),
                   "Column and row, from the top left corner.", pinned ? theme::selected : 0);
    const PassReading& ray = reading->primary();
    if (reading->scale > 1) widgets::note(fmt::format("preview, 1 of {0} × {0} pixels", reading->scale));
    draw_hit(ray);
    widgets::heading("the primary ray's walk");
    draw_counters(ray);
    draw_other_rays(*reading);
    if (pinned) {
        if (widgets::button("release pixel", "Follows the mouse again. Key Esc.")) edit.window.pinned.reset();
    } else {
        widgets::note("click: keep this pixel");
    }
}

}  // namespace kd
