#include "app/panels/verdict_rows.h"

#include <cmath>
#include <fmt/format.h>

#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/io/tables.h"
#include "renderer/measure/oracle.h"
#include "renderer/trace/upper_bound.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr const char* none = "–";

std::string error_text(const JudgedHit& judged, bool both_missed) {
    if (both_missed || judged.verdict == HitVerdict::unfinished) return none;
    return std::isfinite(judged.ulps) ? number_text(judged.ulps) + " ulp" : "one missed";
}

std::string triangle_text(bool known, int triangle) {
    if (!known) return none;
    return triangle >= 0 ? fmt::format("#{}", triangle) : "no hit";
}

/// Of the exact hit; of the one found where there is no exact one.
std::string edge_text(const JudgedHit& judged, const Hit& found) {
    if (judged.exact.triangle >= 0) return number_text(edge_distance(judged.exact.u, judged.exact.v));
    return found.triangle >= 0 ? number_text(edge_distance(double(found.u), double(found.v))) : none;
}

/// The pixel's verdict; dashes where it has none yet.
void draw_comparison(const OracleReading* known, const Hit& found) {
    const OracleReading oracle = known ? *known : OracleReading{};
    const JudgedHit& judged = oracle.judged;
    const bool hit = judged.exact.triangle >= 0;
    widgets::value(
        "verdict", known ? std::string(name_of(judged.verdict)) : none,
        "agrees; tie: another answer where neither is wrong; missed, false hit, wrong triangle, t off by more "
        "than 64 units in the last place; unfinished: the walk was given up.",
        known && is_wrong(judged.verdict) ? theme::error : 0);
    widgets::value("found triangle", triangle_text(known, found.triangle), "What the traversal answered.");
    widgets::value("exact triangle", triangle_text(known, judged.exact.triangle),
                   "What a loop over all triangles in double precision answers.");
    widgets::value("exact t", hit ? number_text(judged.exact.t) : none, "In scene units.");
    widgets::value("error of t", error_text(judged, !hit && found.triangle < 0),
                   "Found minus exact, in units in the last place of the exact t as a float.");
    widgets::value("to the edge", edge_text(judged, found),
                   "Least barycentric coordinate of the exact hit (of the one found where there is no exact one).");
}

/// Dashes where there is none.
void draw_ray(const Ray* known, Edit& edit) {
    if (!widgets::fold("ray, exact", false)) return;
    const Ray ray = known ? *known : Ray{};
    const auto number = [known](const char* label, float value) {
        widgets::value(label, known ? hex_float(value) : none, "A hexadecimal float: every bit of the number.");
    };
    number("ox", ray.origin.x);
    number("oy", ray.origin.y);
    number("oz", ray.origin.z);
    number("dx", ray.direction.x);
    number("dy", ray.direction.y);
    number("dz", ray.direction.z);
    number("tmin", ray.t_min);
    number("tmax", ray.t_max);
    if (widgets::button("copy ray", "To the clipboard, as a table that kdscope trace --rays reads.", known != nullptr))
        edit.do_once(Action::copy_ray);
}

void draw_wrong_pixels(const EngineState& state, Edit& edit) {
    const JudgedLayer* judged = state.judged();
    const double n = judged ? double(judged->compared()) : 0;
    const std::int64_t wrong = judged ? judged->wrong() : 0;
    std::string text = none;
    if (judged) text = fmt::format("{} of {}", number_text(double(wrong)), number_text(n));
    if (state.judging.active) text = fmt::format("comparing {:.0f} %", 100 * state.judging.fraction);
    const std::string bound = wrong == 0 && n > 0
                                  ? fmt::format(" 0 of n means: with 95 % certainty below 3/n = {} of such rays.",
                                                number_text(upper_bound_95(0, judged->compared())))
                                  : "";
    widgets::value("wrong pixels", text, "Of all that have such a ray." + bound, wrong > 0 ? theme::error : 0);
    const int place = judged && edit.window.pinned ? place_number(*judged, *edit.window.pinned) : 0;
    std::string places = none;
    if (judged) places = number_text(double(judged->places.size()));
    if (place > 0) places = fmt::format("{} of {}", place, places);
    widgets::value(
        "places", places,
        "Wrong pixels lie together: places that are a 24th of the picture's shorter side apart, the one with "
        "most wrong pixels around first. The arrow keys go from pixel to pixel.");
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (widgets::button("previous", "Pins the place before. Key Shift W.", wrong > 0, half))
        edits::pin_wrong(state, edit, true);
    ImGui::SameLine();
    if (widgets::button("next", "Pins the next place, or the nearest where the pinned pixel lies at none. Key W.",
                        wrong > 0, half))
        edits::pin_wrong(state, edit, false);
}

}  // namespace

void draw_verdict(const EngineState& state, Edit& edit) {
    if (!needs_oracle(edit.session.view)) return;
    const std::optional<PixelReading>& pixel = state.pinned ? state.pinned : state.hovered;
    const Pass rays = state.judged() ? state.judged()->rays : edit.session.view.map.rays;
    widgets::heading(fmt::format("{} rays in double precision", ray_names[std::size_t(rays)]).c_str());
    const OracleReading* known = pixel && pixel->oracle ? &*pixel->oracle : nullptr;
    draw_comparison(known, known ? pixel->passes[std::size_t(known->rays)].hit : Hit{-1, 0.0f, 0.0f, 0.0f});
    draw_wrong_pixels(state, edit);
    draw_ray(known ? &known->ray : nullptr, edit);
}

}  // namespace kd
