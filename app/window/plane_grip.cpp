#include "app/window/plane_grip.h"

#include <array>
#include <cmath>
#include <utility>

#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "viz/projection.h"

namespace kd {

namespace {

constexpr float grip_radius = 7;

}  // namespace

/// The rectangle of a plane in a cell, and the way from the picture to it.
struct PlaneView {
    const Rectangle& area;
    ImVec2 scale;  // window pixels per picture pixel
    HandSplit plane;
    Aabb cell;
    Projection projection;

    [[nodiscard]] Vec3 at(float u, float v, float position) const {
        const int axis = plane.axis, other = (axis + 1) % 3, last = (axis + 2) % 3;
        const Vec3 extent = cell.extent();
        Vec3 point;
        point[axis] = position;
        point[other] = cell.lower[other] + u * extent[other];
        point[last] = cell.lower[last] + v * extent[last];
        return point;
    }
    [[nodiscard]] ImVec2 on_screen(const PixelPoint& p) const {
        return {area.x + float(p.x) * scale.x, area.y + float(p.y) * scale.y};
    }
    [[nodiscard]] std::vector<ImVec2> outline() const {
        const std::array<Vec3, 4> corners{at(0, 0, plane.position), at(1, 0, plane.position), at(1, 1, plane.position),
                                          at(0, 1, plane.position)};
        std::vector<ImVec2> points;
        for (const PixelPoint& p : projection.project_polygon(corners)) points.push_back(on_screen(p));
        return points;
    }
    /// The position along the axis that the mouse points at, on the line through a place of the rectangle.
    [[nodiscard]] std::optional<double> position_at(ImVec2 mouse, float u, float v) const {
        const float low = cell.lower[plane.axis];
        Vec3 direction(0);
        direction[plane.axis] = cell.extent()[plane.axis];
        const auto s = projection.nearest_on_line(at(u, v, low), direction, double((mouse.x - area.x) / scale.x),
                                                  double((mouse.y - area.y) / scale.y));
        if (!s) return std::nullopt;
        return double(low) + *s * double(direction[plane.axis]);
    }
};

namespace {

std::optional<PlaneView> view_of(const Rectangle& area, const EngineState& state, const Edit& edit) {
    if (!state.picture || !state.selected || state.loading.active || edit.window.node != state.selected->path)
        return std::nullopt;
    const std::optional<HandSplit> plane = edits::shown_plane(state, edit);
    if (!plane) return std::nullopt;
    const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
    const int width = state.session.width, height = state.session.height;
    return PlaneView{area,
                     {1 / density.x, 1 / density.y},
                     *plane,
                     state.selected->cell,
                     Projection(pinhole(state.picture->traced.camera, width, height), width, height)};
}

struct Grip {
    float u = 0.5f, v = 0.5f;  // on the rectangle
    ImVec2 place;
};

/// The place of the rectangle that is seen nearest to the middle of what is seen of it.
std::optional<Grip> grip_of(const PlaneView& view) {
    const std::vector<ImVec2> outline = view.outline();
    if (outline.size() < 3) return std::nullopt;
    ImVec2 middle{0, 0};
    for (const ImVec2& p : outline) {
        middle.x += p.x / float(outline.size());
        middle.y += p.y / float(outline.size());
    }
    constexpr int steps = 8;
    std::optional<Grip> best;
    float least = HUGE_VALF;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const float u = float(i) / steps, v = float(j) / steps;
            const auto seen = view.projection.project(view.at(u, v, view.plane.position));
            if (!seen) continue;
            const ImVec2 place = view.on_screen(*seen);
            const float distance = std::hypot(place.x - middle.x, place.y - middle.y);
            if (distance >= least || !view.area.contains(place)) continue;
            least = distance;
            best = Grip{u, v, place};
        }
    return best;
}

bool is_near(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y) <= theme::px(grip_radius + 3); }

constexpr const char* no_way = "The plane's axis points at the eye: turn the camera to drag it.";
constexpr const char* what_it_is =
    "The split plane of the node selected. Drag it along its axis: the tree is built anew "
    "with it, and the camera stays. "
    "Ctrl Z takes it back.";

}  // namespace

/// The mouse comes to the grip, and takes it with a press.
bool PlaneGrip::take(const PlaneView& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::optional<Grip> grip = grip_of(view);
    if (!grip || !ImGui::IsItemHovered() || !is_near(mouse, grip->place)) return false;
    const std::optional<double> at = view.position_at(mouse, grip->u, grip->v);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!ImGui::IsItemActive()) widgets::show_tooltip(at ? what_it_is : no_way, mouse);
    if (!at || !ImGui::IsItemActivated() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return false;
    held_ = true;
    along_u_ = grip->u;
    along_v_ = grip->v;
    offset_ = double(view.plane.position) - *at;
    moved_ = false;
    return true;
}

bool PlaneGrip::handle(const Rectangle& area, const EngineState& state, Edit& edit) {
    const bool pressed = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const std::optional<PlaneView> view =
        shows(edit, splits_panel) ? view_of(area, state, edit) : std::optional<PlaneView>();
    if (!view || !pressed) held_ = false;
    if (!view) return false;
    if (!held_) return take(*view);
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    HandSplit plane = view->plane;
    if (const auto at = view->position_at(ImGui::GetIO().MousePos, along_u_, along_v_))
        if (const auto kept = edits::inside(view->cell, plane.axis, float(*at + offset_))) {
            if (*kept == plane.position) return true;
            plane.position = *kept;
            edits::put_plane(edit, plane, !std::exchange(moved_, true));
        }
    return true;
}

void PlaneGrip::draw(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit) const {
    const std::optional<PlaneView> view = view_of(area, state, edit);
    if (!view) return;
    const std::vector<ImVec2> outline = view->outline();
    if (outline.size() < 3) return;
    list.AddConvexPolyFilled(outline.data(), int(outline.size()), theme::faded(theme::selected, 0.25f));
    list.AddPolyline(outline.data(), int(outline.size()), theme::outline, ImDrawFlags_Closed, theme::px(3.5f));
    list.AddPolyline(outline.data(), int(outline.size()), theme::selected, ImDrawFlags_Closed, theme::px(1.5f));
    if (!shows(edit, splits_panel)) return;
    std::optional<ImVec2> place;
    if (held_) {
        const auto seen = view->projection.project(view->at(along_u_, along_v_, view->plane.position));
        if (seen) place = view->on_screen(*seen);
    } else if (const auto grip = grip_of(*view)) {
        place = grip->place;
    }
    if (!place) return;
    const float radius = theme::px(grip_radius);
    list.AddCircleFilled(*place, radius + theme::px(2), theme::outline);
    list.AddCircleFilled(*place, radius, held_ ? theme::text : theme::selected);
    if (Places* places = Places::current())
        places->add("picture/plane", {place->x - radius, place->y - radius}, {place->x + radius, place->y + radius});
}

}  // namespace kd
