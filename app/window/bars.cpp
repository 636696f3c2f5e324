#include "app/window/bars.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

#include "app/assets.h"
#include "app/choices.h"
#include "app/panels/panel.h"
#include "app/report/machine_info.h"
#include "app/tracer_choices.h"
#include "app/window/places.h"
#include "app/window/recent_files.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/traversal.h"
#include "renderer/trace/walk_choices.h"
#include "viz/numbers.h"

namespace kd {

namespace {

constexpr float name_from_width = 1040;  // narrower windows need the room

/// Files opened before, the procedural scenes at a few sizes, and the files that come with the program.
std::vector<widgets::Option> scene_options(const Edit& edit) {
    std::vector<widgets::Option> options = recent_options(edit.window.recent_files, edit.session.scene);
    for (const ProceduralScene& scene : procedural_scenes()) {
        const std::string base(scene.name);
        const std::string summary(scene.summary);
        if (scene.default_size == 0) {
            options.push_back({base, summary});
            continue;
        }
        for (const int size : {scene.default_size, 10 * scene.default_size})
            if (size <= scene.largest_size) options.push_back({fmt::format("{}:{}", base, size), summary});
    }
    for (const auto& file : shipped_scenes())
        options.push_back({file.filename().string(), "A file that comes with the program."});
    return options;
}

void draw_scene(Edit& edit) {
    std::string scene = edit.session.scene;
    if (widgets::combo(
            "scene", scene, scene_options(edit),
            "The scene. Files can be dropped onto the window: .gltf or .glb. Those opened before come first.",
            theme::px(164)))
        edits::choose_scene(edit, scene);
}

void draw_map(Edit& edit) {
    std::string map = edit.session.view.map.map;
    if (widgets::combo("map", map, widgets::options_of(maps()), "The number that colours stand for. Key M: the next.",
                       theme::px(132)))
        edits::show_map(edit, map);
}

void draw_modes(Edit& edit) {
    const ViewConfig& view = edit.session.view;
    const MapInfo* map = find_map(view.map.map);
    const bool tiles = map && map->over_tiles();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, 0});
    if (widgets::segment("Beauty", !view.show_map, "The image alone. Key H.")) edits::show_beauty(edit);
    ImGui::SameLine();
    const bool oracle = map && map->needs_oracle();
    if (widgets::segment("Heat", view.show_map && !tiles && !oracle, "What each pixel's rays cost. Key H."))
        edits::show_heat(edit);
    ImGui::SameLine();
    if (widgets::segment("Divergence", view.show_map && tiles,
                         "What pixels lose by waiting for their neighbours in a SIMD group. Key D."))
        edits::show_divergence(edit);
    ImGui::SameLine();
    if (widgets::segment("Oracle", view.show_map && oracle,
                         "Whether each pixel's ray found what a loop over all triangles finds in double precision."))
        edits::show_oracle(edit);
    ImGui::PopStyleVar();
    ImGui::SameLine();
    draw_map(edit);
    ImGui::SameLine(0, theme::px(12));
    if (widgets::segment("Splits", view.overlay.show, "The tree's split planes over the picture. Key S."))
        edit.session.view.overlay.show = !view.overlay.show;
}

/// Two settings to go back and forth between.
void draw_comparison(Edit& edit) {
    const bool b = edit.window.shows_b;
    const char* about = "Two settings, A and B, of everything but scene and camera. B begins as a copy of A: change "
                        "it, and go back and "
                        "forth. Key Tab.";
    ImGui::SameLine(0, theme::px(12));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, 0});
    if (widgets::segment("A", !b, about) && b) edits::compare(edit);
    ImGui::SameLine();
    if (widgets::segment("B", b, about) && !b) edits::compare(edit);
    ImGui::PopStyleVar();
}

std::string machines_text(const EngineState& state) {
    const std::string gpu = !state.gl.known        ? "not looked for yet"
                            : state.gl.available() ? state.gl.renderer + ", OpenGL " + state.gl.version
                                                   : "none: " + state.gl.unavailable;
    return fmt::format("The picture is traced on the {}. Click or V: the other machine.\n\nCPU: {}\nGPU: {}",
                       runs_on_cpu(state.session.tracer) ? "CPU" : "GPU", cpu_renderer(state.session.threads), gpu);
}

/// "CPU · stack" or "GPU · restart · as-published", with a dot in the machine's accent.
void draw_badge(const EngineState& state, Edit& edit) {
    const bool cpu = runs_on_cpu(state.session.tracer);
    const TraceConfig& trace = state.session.trace;
    const char* machine = cpu ? "CPU" : state.gl.software ? "GPU (software)" : "GPU";
    const TracerKind tracer = state.session.tracer;
    const bool usual = tracer == TracerKind::cpu || tracer == TracerKind::gl_fragment;
    std::string what =
        fmt::format("{}{} · {}", machine, usual ? "" : " · " + tracer_text(tracer, trace), info(trace.traversal).name);
    if (const Rules rules = rules_in_force(trace); rules != Rules::robust)
        what += fmt::format(" · {}", info(rules).name);
    const float help = ImGui::CalcTextSize("?").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float width = ImGui::CalcTextSize(what.c_str()).x + theme::px(24);
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - width - help - theme::px(24)));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("##badge", {width, ImGui::GetFrameHeight()})) edits::switch_tracer(state, edit);
    if (ImGui::IsItemHovered()) widgets::hint(machines_text(state));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = corner.y + ImGui::GetFrameHeight() / 2;
    list.AddCircleFilled({corner.x + theme::px(7), middle}, theme::px(4), cpu ? theme::cpu : theme::gpu);
    list.AddText({corner.x + theme::px(18), middle - ImGui::GetFontSize() / 2}, theme::text, what.c_str());
    ImGui::SameLine(ImGui::GetWindowWidth() - help - theme::px(8));
    if (widgets::button("?", "All keys, and the size of the text. Key F1.", true, 0))
        edit.window.help = !edit.window.help;
}

std::string status_text(const EngineState& state, const WindowSettings& window) {
    if (state.loading.active) return "loading " + state.loading_name;
    if (!state.picture) return "starting";
    const TracedFrame& traced = state.picture->traced;
    const std::string flight =
        window.camera_style == CameraStyle::fly ? fmt::format("   ·   flying, speed {}", window.fly_speed) : "";
    return fmt::format("{} × {}, all rays with their counters in {} ms   ·   tree built in {} ms{}",
                       state.session.width, state.session.height, number_text(traced.time.total_ms),
                       number_text(state.last_build_ms), flight);
}

/// Shaders being compiled; the picture before them stays meanwhile.
void draw_compiling(const EngineState& state) {
    if (state.compiling == 0) return;
    ImGui::SameLine(0, theme::px(16));
    ImGui::TextUnformatted(fmt::format("compiling shaders ({})", state.compiling).c_str());
    Places::note("compiling");
}

void draw_cancel(Edit& edit) {
    ImGui::SameLine();
    if (ImGui::SmallButton("cancel")) edit.do_once(Action::cancel_build);
    Places::note("cancel");
    widgets::hint("Keeps the tree that is shown.");
}

/// The bar of the work that takes longest now.
void draw_work(const EngineState& state, Edit& edit) {
    const bool building = state.building.active;
    const bool tracing = state.tracing.active && !state.motion.playing;  // else bars would flicker
    if (state.motion.posing && !building && !tracing) {
        ImGui::SameLine(0, theme::px(16));
        ImGui::TextUnformatted("posing");
        return draw_cancel(edit);
    }
    if (!building && !tracing && !state.judging.active) return;
    const Progress& work = building ? state.building : tracing ? state.tracing : state.judging;
    const char* beside = needs_walks(state.session.view) ? "walking" : "comparing";
    const char* name = building ? "building" : tracing ? "refining" : beside;
    ImGui::SameLine(0, theme::px(16));
    ImGui::SetNextItemWidth(theme::px(150));
    ImGui::ProgressBar(work.fraction, {theme::px(150), ImGui::GetTextLineHeight() + theme::px(2)},
                       fmt::format("{} {:.0f} %", name, 100 * work.fraction).c_str());
    if (building) draw_cancel(edit);
}

}  // namespace

void begin_area(const char* name, const Rectangle& area, ImVec2 padding, ImGuiWindowFlags more) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | more |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
}

void draw_top_bar(const Rectangle& area, const EngineState& state, Edit& edit) {
    const Section section("top");
    begin_area("##top", area, {theme::px(12), std::round((area.height - ImGui::GetFrameHeight()) / 2)},
               ImGuiWindowFlags_NoScrollbar);
    if (area.width >= theme::px(name_from_width)) {
        ImGui::PushFont(theme::font(theme::Type::heading));
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("kdscope");
        ImGui::PopFont();
        ImGui::SameLine(0, theme::px(16));
    }
    draw_scene(edit);
    ImGui::SameLine(0, theme::px(16));
    draw_modes(edit);
    draw_comparison(edit);
    draw_badge(state, edit);
    ImGui::End();
}

void draw_bottom_tabs(Edit& edit) {
    const Section section("bottom");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1, ImGui::GetStyle().ItemSpacing.y});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme::px(8), 0});
    for (const Panel& panel : panels()) {
        if (panel.place != PanelPlace::bottom) continue;
        std::string name = panel.title;
        std::transform(name.begin() + 1, name.end(), name.begin() + 1,
                       [](unsigned char c) { return char(std::tolower(c)); });
        if (widgets::segment(name.c_str(), edit.window.bottom == panel.title, panel.hint))
            edit.window.bottom = panel.title;
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::PopStyleVar(2);
}

void draw_status_line(const Rectangle& area, const EngineState& state, Edit& edit) {
    const Section section("status");
    begin_area("##status", area, {theme::px(12), std::round((area.height - ImGui::GetTextLineHeight()) / 2)},
               ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
    ImGui::TextUnformatted(status_text(state, edit.window).c_str());
    ImGui::PopStyleColor();
    draw_work(state, edit);
    draw_compiling(state);
    const char* hint = "H heat   S splits   T traversal   click: pin a pixel   F1 all keys, text size";
    const float width = ImGui::CalcTextSize(hint).x;
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() < area.width - width - theme::px(24)) {
        ImGui::SetCursorPosX(area.width - width - theme::px(12));
        ImGui::PushStyleColor(ImGuiCol_Text, theme::dim_text);
        ImGui::TextUnformatted(hint);
        ImGui::PopStyleColor();
    }
    ImGui::End();
}

}  // namespace kd
