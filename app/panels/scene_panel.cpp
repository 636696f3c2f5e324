// SCENE: what is in it, and what loading had to change.
#include <fmt/format.h>
#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>
#include <utility>

#include "app/panels/applies.h"
#include "app/panels/panel.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/scene/procedural.h"
#include "renderer/scene/units.h"
#include "viz/numbers.h"

namespace kd {

namespace {

std::string size_text(const Aabb& bounds) {
    const Vec3 d = bounds.extent();
    return fmt::format("{} × {} × {}", number_text(double(d.x)), number_text(double(d.y)), number_text(double(d.z)));
}

bool takes_seed(const std::string& scene) {
    const ProceduralScene* procedural = find_procedural(scene);
    return procedural && procedural->seeded;
}

/// A field for any scene there is: names with their sizes, files by their paths.
void draw_open(const EngineState& state, Edit& edit) {
    const std::string refused = edits::why_refused(state, edit);
    // Enter took the keys away from the field; who mistyped goes on typing there, not pressing keys of the window.
    if (!refused.empty() && std::exchange(edit.window.scene_awaited, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint("##open", "open: scatter:5000, ~/model.glb", &edit.window.scene_text,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    Places::note("open");
    widgets::hint(
        "Enter opens a scene by its name and number of triangles, such as ball:20000 or stress:T16=1e-4, or a "
        ".gltf or .glb file by its path. Also a session that was saved.");
    if (entered) edits::open_typed(edit);
    if (refused.empty()) return;
    widgets::note(refused, theme::error);
    Places::note("refused");
}

}  // namespace

void draw_scene_panel(const EngineState& state, Edit& edit) {
    if (!state.world) {
        widgets::note("loading");
        return;
    }
    draw_open(state, edit);
    const FlatScene& scene = state.world->scene();
    widgets::value("triangles", number_text(double(scene.triangles.size())), "After placing all meshes in the world.");
    widgets::value("lights", number_text(double(scene.lights.size())), "Each light costs one shadow ray per hit.");
    widgets::value("materials", number_text(double(scene.materials.size())),
                   "A reflective material makes the reflection passes necessary.");
    if (why_absent(state, edit.session.trace, Feature::textures).empty())
        widgets::value("textures", number_text(double(scene.textures.size())), "Images on surfaces.");
    widgets::value("size", size_text(to_scene_units(scene, scene.bounds)),
                   "Extent of all triangles along x, y and z, in scene units.");
    if (takes_seed(edit.session.scene)) {
        int seed = int(edit.session.seed);
        if (widgets::slider("seed", seed, 1, 100, "%d", "Another arrangement of the same scene."))
            edit.session.seed = unsigned(seed);
    }
    for (const std::string& note : scene.notes) widgets::note(note);
}

}  // namespace kd
