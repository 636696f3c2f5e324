#include "app/window/viewport.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/window/camera_moves.h"
#include "app/window/theme.h"

namespace kd {

namespace {

constexpr float radians_per_pixel = 0.008f;
constexpr float click_slack = 4;  // pixels that the mouse may move in a click
constexpr float zoom_step = 0.88f;
constexpr double dim_after_s = 0.4;
constexpr float fly_seconds = 4;  // to cross the scene at speed 1

Camera current(const EngineState& state, const Edit& edit) { return edit.session.camera.value_or(state.camera); }

/// The pinned pixel stays on its ray: the angle of view belongs to the height, and the middle stays the middle.
void resize(Edit& edit, int width, int height) {
    Session& session = edit.session;
    if (session.width == width && session.height == height) return;
    if (edit.window.pinned) {
        PixelPosition& p = *edit.window.pinned;
        const double zoom = double(height) / session.height;
        p.x = std::clamp(int((p.x + 0.5 - 0.5 * session.width) * zoom + 0.5 * width), 0, width - 1);
        p.y = std::clamp(int((p.y + 0.5) * zoom), 0, height - 1);
    }
    session.width = width;
    session.height = height;
}

}  // namespace

void Viewport::update_texture(const EngineState& state) {
    if (state.picture == uploaded_ || !state.picture) return;
    uploaded_ = state.picture;
    stale_since_ = -1;  // while a plane or a slider is dragged, tree after tree is on its way
    image_.upload(uploaded_->image, uploaded_->traced.scale > 1 || uploaded_->sketch);
}

void Viewport::draw(const Rectangle& area, const EngineState& state, double now, float seconds, Edit& edit) {
    update_texture(state);
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::sunken);
    ImGui::Begin("##picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::InvisibleButton("##canvas", {area.width, area.height},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
    resize(edit, std::max(1, int(std::lround(area.width * density.x))),
           std::max(1, int(std::lround(area.height * density.y))));
    handle_mouse(area, state, edit);
    handle_flight(state, seconds, edit);

    // What is about to be replaced as a whole is dimmed, never taken away.
    const bool replaced = state.loading.active || state.building.active;
    if (!replaced)
        stale_since_ = -1;
    else if (stale_since_ < 0)
        stale_since_ = now;
    const bool dim = replaced && now - stale_since_ > dim_after_s;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{area.x, area.y};
    const ImVec2 end{area.x + area.width, area.y + area.height};
    if (!image_.empty()) {
        list.AddImage(image_.id(), corner, end, {0, 0}, {1, 1}, dim ? IM_COL32(140, 140, 140, 255) : IM_COL32_WHITE);
        draw_marks(list, area, state, edit, {1 / density.x, 1 / density.y});
        grip_.draw(list, area, state, edit);
    }
    draw_messages(list, area, state, edit, now);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (edit.window.legend && uploaded_) draw_legend(area, *uploaded_, edit.window.legend_corner);
    draw_unfinished(area, state, edit);
}

void Viewport::handle_mouse(const Rectangle& area, const EngineState& state, Edit& edit) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = ImGui::IsItemHovered();
    edit.hovered.reset();
    if (over && area.contains(io.MousePos))
        edit.hovered = PixelPosition{int((io.MousePos.x - area.x) * io.DisplayFramebufferScale.x),
                                     int((io.MousePos.y - area.y) * io.DisplayFramebufferScale.y)};
    if (!state.picture || state.loading.active) return;  // no camera to move yet
    if (over && io.MouseWheel != 0)
        edit.session.camera = zoom(current(state, edit), std::pow(zoom_step, io.MouseWheel),
                                   glm::length(state.world->scene().bounds.extent()));
    if (grip_.handle(area, state, edit)) {
        dragged_ = 1e6f;  // its release pins nothing
        return;
    }
    // What the mouse moved in the frame of the press led to it: a jump and a click may come in one frame.
    if (ImGui::IsItemActivated())
        dragged_ = 0;
    else if (ImGui::IsItemActive())
        handle_drag(area, state, edit);
    handle_click(state, edit);
}

void Viewport::handle_drag(const Rectangle& area, const EngineState& state, Edit& edit) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 moved = io.MouseDelta;
    dragged_ += std::abs(moved.x) + std::abs(moved.y);
    if (dragged_ < theme::px(click_slack) || (moved.x == 0 && moved.y == 0)) return;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (left && !io.KeyShift) {
        const float turn = radians_per_pixel / theme::px(1);
        const auto move = edit.window.camera_style == CameraStyle::orbit ? orbit : look_around;
        edit.session.camera = move(current(state, edit), moved.x * turn, moved.y * turn);
    } else {
        edit.session.camera = pan(current(state, edit), moved.x / area.height, moved.y / area.height);
    }
}

void Viewport::handle_click(const EngineState& state, Edit& edit) {
    if (!ImGui::IsItemHovered()) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        // The first click was not meant.
        edit.window.pinned = pinned_before_click_;
        edit.window.node = node_before_click_;
        edit.window.follow = Follow::nothing;
        const std::optional<PixelReading>& reading = state.hovered;
        if (!reading || reading->primary().hit.triangle < 0) return;
        const Camera camera = current(state, edit);
        const Vec3 direction = pixel_direction(camera, reading->pixel, edit.session.width, edit.session.height);
        edit.session.camera = look_at(camera, camera.eye + direction * reading->primary().hit.t);
        dragged_ = 1e6f;  // its release pins nothing
        return;
    }
    if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        dragged_ < theme::px(click_slack)) {
        pinned_before_click_ = edit.window.pinned;
        node_before_click_ = edit.window.node;
        edits::pin(edit);
    }
}

void Viewport::handle_flight(const EngineState& state, float seconds, Edit& edit) {
    const bool by_left = edit.window.camera_style == CameraStyle::fly && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    flying_ = ImGui::IsItemActive() && (by_left || ImGui::IsMouseDown(ImGuiMouseButton_Right));
    if (!flying_ || !state.world || state.loading.active) return;
    const auto held = [](int more, int less) { return float(ImGui::IsKeyDown(more)) - float(ImGui::IsKeyDown(less)); };
    const float forward = held(GLFW_KEY_W, GLFW_KEY_S);
    const float right = held(GLFW_KEY_D, GLFW_KEY_A);
    const float up = held(GLFW_KEY_E, GLFW_KEY_Q);
    if (forward == 0 && right == 0 && up == 0) return;
    const float size = glm::length(state.world->scene().bounds.extent());
    const float step = size * edit.window.fly_speed * std::min(seconds, 0.1f) / fly_seconds;
    edit.session.camera = fly(current(state, edit), forward * step, right * step, up * step);
}

}  // namespace kd
