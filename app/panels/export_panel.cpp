// EXPORT: pictures and tables of what is shown. Names count up; nothing is overwritten.
#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <filesystem>

#include "app/panels/panel.h"
#include "app/window/home_path.h"
#include "app/window/places.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"

namespace kd {

void draw_export_panel(const EngineState& state, Edit& edit) {
    const bool ready = state.picture && !state.stale();
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    const auto button = [&](const char* label, Action action, const char* tooltip) {
        // A session is what was chosen, of which the picture need not tell yet.
        const bool can = action == Action::save_session ? state.picture != nullptr : ready;
        if (widgets::button(label, can ? tooltip : "As soon as the picture is complete.", can, third))
            edit.do_once(action);
    };
    button("figure", Action::export_figure, "PNG with title, legend and a caption that names every setting. Key F12.");
    ImGui::SameLine();
    button("picture", Action::export_picture, "PNG of the picture alone.");
    ImGui::SameLine();
    button("window", Action::export_window, "PNG of the whole window, with its panels.");
    button("CSV", Action::export_csv, "A row per pixel: hit and every counter of every pass.");
    ImGui::SameLine();
    button("JSON", Action::export_json, "Settings, tree, times and counter totals.");
    ImGui::SameLine();
    button("session", Action::save_session,
           "Everything chosen: drop the file onto the window, or open it in SCENE, to have it again. Key Ctrl S.");
    std::error_code error;
    const bool there = std::filesystem::is_directory(home_long(edit.window.folder), error);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(there ? "into" : "into new");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##folder", "folder", &edit.window.folder);
    Places::note("folder");
    widgets::hint("Folder that files are written into, made where there is none. Names count up: kdscope-1.png, "
                  "kdscope-2.png, ...");
    if (edit.exporting.active)
        widgets::progress(edit.exporting.fraction, "writing " + edit.exporting.what);
    else if (!edit.export_error.empty())
        widgets::note(edit.export_error, theme::error);
    else if (!edit.last_export.empty())
        widgets::note(edit.last_export);
}

}  // namespace kd
