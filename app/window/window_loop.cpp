#include "app/window/window_loop.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "app/camera_text.h"
#include "app/fonts.h"
#include "app/panels/panel.h"
#include "app/window/bars.h"
#include "app/window/exporting.h"
#include "app/window/help.h"
#include "app/window/home_path.h"
#include "app/window/keys.h"
#include "app/window/recent_files.h"
#include "app/window/theme.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/tables.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

constexpr double resting_wait_s = 0.25, working_wait_s = 0.03, lively_wait_s = 0.016, preview_wait_s = 0.03;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

double exit_after_s() {
    const std::string text = variable("KDSCOPE_EXIT_AFTER_S");
    double seconds = std::numeric_limits<double>::infinity();
    std::from_chars(text.data(), text.data() + text.size(), seconds);
    return seconds;
}

}  // namespace

WindowLoop::WindowLoop(GlfwWindow& window, const Session& start, const WindowMemory& memory)
    : window_(window), font_(picture_font()), log_(variable("KDSCOPE_EVENT_LOG")),
      state_file_(variable("KDSCOPE_STATE_FILE")), sizes_(memory.sizes), exporter_([] { glfwPostEmptyEvent(); }) {
    edit_.window = memory.settings;
    std::error_code error;
    edit_.window.folder = home_short(std::filesystem::current_path(error));
    (void)gl_.load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
    install_callbacks();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().UserData = &places_;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    apply_scale();
    edits::remember_view(edit_, start.view);

    EngineOptions options;
    options.open_gl = window.tracing_context();
    options.wake = [] { glfwPostEmptyEvent(); };
    Session session = start;
    const WindowSize size = window.size();
    layout_ = divide(float(size.width), float(size.height), sizes_, scale_, true);
    session.width = int(layout_.picture.width);
    session.height = int(layout_.picture.height);
    engine_ = std::make_unique<Engine>(session, std::move(options));
    viewport_ = std::make_unique<Viewport>(gl_);
}

WindowLoop::~WindowLoop() {
    engine_.reset();
    viewport_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

WindowMemory WindowLoop::memory() const {
    const WindowSize size = window_.size();
    return {size.width, size.height, window_.maximised(), sizes_, edit_.window};
}

bool WindowLoop::resting() const { return lively_frames_ <= 0; }

void WindowLoop::wait() const {
    const EngineState& state = engine_->state();
    const bool working =
        state.working() || state.stale() || state.motion.playing || state.stability.active || edit_.exporting.active;
    if (window_.hidden()) return glfwWaitEventsTimeout(resting_wait_s);
    glfwWaitEventsTimeout(!resting() ? lively_wait_s : working ? working_wait_s : resting_wait_s);
}

void WindowLoop::run(const std::stop_token& stop) {
    const std::stop_callback wake(stop, [] { glfwPostEmptyEvent(); });
    const double end = exit_after_s();
    while (!glfwWindowShouldClose(window_.handle()) && !stop.stop_requested() && engine_->now() < end) {
        wait();
        const bool news = engine_->poll();
        fetch_exports();
        if (news) lively_frames_ = std::max(lively_frames_, 1);
        if (window_.hidden()) {  // nothing is drawn or timed, and the first frame after it shows what went on
            engine_->allow_duel(false);
            lively_frames_ = frames_after_input;
            continue;
        }
        const EngineState& state = engine_->state();
        // A measurement's bar moves too, four times a second: drawn as often as others it would take from what is
        // measured.
        const bool moving = state.working() || state.stability.active || state.needs.active ||
                            !state.messages.empty() || edit_.exporting.active;
        if (lively_frames_ > 0 || moving) {
            const double begun = engine_->now();
            draw_frame();
            drawing_s_ = engine_->now() - begun;
        }
        --lively_frames_;
    }
}

/// An edit that needs another picture is given the time that its preview takes before anything goes to the screen: one
/// frame with the answer comes sooner than one without and then another.
void WindowLoop::draw_frame() {
    const std::uint64_t before = engine_->state().generation;
    lay_out_frame();
    if (engine_->state().generation != before) {
        engine_->wait_for_picture(preview_wait_s);
        lay_out_frame();
    }
    present_frame();
}

/// Between two frames: Dear ImGui takes no other fonts within one.
void WindowLoop::apply_scale() {
    const float content = window_.content_scale();
    edit_.room_for_text = std::min(largest_text_scale, room_for_text(window_.size(), content));
    const float wanted = content * std::min(edit_.window.text_scale, edit_.room_for_text);
    if (wanted == scale_) return;
    scale_ = wanted;
    theme::apply(scale_);
    // Not all device objects: Dear ImGui 1.86 forgets that the new vertex buffers are empty, and draws nothing.
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    lively_frames_ = frames_after_input;
}

void WindowLoop::lay_out_frame() {
    apply_scale();
    places_.clear();
    settled_ = true;
    take_keys();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    take_buttons();
    ImGui::NewFrame();
    const double now = engine_->now();
    const auto seconds = float(now - last_frame_);
    last_frame_ = now;
    edit_.session = engine_->state().session;
    edit_.actions.clear();
    edit_.session_file.clear();
    apply_keys();

    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (size.x >= 1 && size.y >= 1) {  // nothing to see of a minimised window
        layout_ = divide(size.x, size.y, sizes_, scale_, edit_.window.panels);
        viewport_->draw(layout_.picture, engine_->state(), now, seconds, edit_);
        draw_panels(layout_);
        if (edit_.window.panels) draw_splitters(layout_, sizes_, scale_);
        draw_help(edit_);
    }
    ImGui::Render();
    apply_edit();
}

void WindowLoop::present_frame() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    gl_.Viewport(0, 0, width, height);
    gl_.ClearColor(0.07f, 0.07f, 0.08f, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (std::exchange(window_export_, false)) write_files(Action::export_window);
    const std::shared_ptr<const Picture> shown = engine_->state().picture;
    glfwSwapBuffers(window_.handle());
    log_.presented(shown.get(), system_ms());
    const bool answered = lively_frames_ <= 1;  // this frame is the last that the input asked for
    // Who clicks where the file says that something is must not miss it because the next frame moves it.
    if (settled_) state_file_.update(engine_->state(), edit_, layout_.picture, places_, answered ? inputs_ : answered_);
    if (answered) answered_ = inputs_;
}

const Panel& WindowLoop::bottom_panel() const {
    const Panel* shown = nullptr;
    for (const Panel& panel : panels())
        if (panel.place == PanelPlace::bottom && (!shown || panel.title == edit_.window.bottom)) shown = &panel;
    return *shown;
}

void WindowLoop::draw_panels(const Layout& layout) {
    const EngineState& state = engine_->state();
    draw_top_bar(layout.top, state, edit_);
    draw_status_line(layout.status, state, edit_);
    if (!edit_.window.panels) return;
    draw_column("##left", layout.left, PanelPlace::left, false);
    draw_right_column(layout.right);
    draw_column("##bottom", layout.bottom, PanelPlace::bottom, false);
}

float WindowLoop::draw_column(const char* name, const Rectangle& area, PanelPlace place, bool staying) {
    const bool bottom = place == PanelPlace::bottom;
    const float padding = staying ? 0 : theme::px(8);
    begin_area(name, area, {theme::px(12), padding}, bottom ? ImGuiWindowFlags_NoScrollbar : 0);
    if (bottom) draw_bottom_tabs(edit_);
    for (const Panel& panel : panels()) {
        if (panel.place != place || panel.stays != staying || (bottom && &panel != &bottom_panel())) continue;
        const bool tall = ImGui::GetIO().DisplaySize.y >= theme::px(panel.open_from);
        const ImGuiTreeNodeFlags flags = tall ? ImGuiTreeNodeFlags_DefaultOpen : 0;
        const bool open = bottom || ImGui::CollapsingHeader(panel.title, flags);
        if (!bottom) Places::note(panel.title);
        if (!open) continue;
        const Section section(panel.title);
        panel.draw(engine_->state(), edit_);
        ImGui::Dummy({0, theme::px(1)});
    }
    const float height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + padding;
    ImGui::End();
    return height;
}

/// Panels that stay follow the others where there is room for all, and stand at the lower end where the others scroll.
void WindowLoop::draw_right_column(const Rectangle& area) {
    const ColumnHeights before = right_heights_;
    const float upper = upper_height(before, area.height);
    right_heights_.scrolling = draw_column("##right", {area.x, area.y, area.width, upper}, PanelPlace::right, false);
    const float bar = before.scrolling > upper ? ImGui::GetStyle().ScrollbarSize : 0;  // headers end below each other
    right_heights_.staying = draw_column("##staying", {area.x, area.y + upper, area.width - bar, area.height - upper},
                                         PanelPlace::right, true);
    settled_ = right_heights_ == before;
    if (!settled_) lively_frames_ = std::max(lively_frames_, 2);  // drawn by the heights of before
}

void WindowLoop::apply_keys() {
    const bool list_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    const bool meant_elsewhere = list_open || ImGui::GetIO().WantTextInput;
    for (const KeyEvent& press : keys_) {
        const bool flies = viewport_->flying() && press.key >= GLFW_KEY_A && press.key <= GLFW_KEY_Z;
        // Behind the help nothing changes but the size of its own text.
        const bool behind = edit_.window.help && !(press.modifiers & GLFW_MOD_CONTROL) && press.key != GLFW_KEY_F1 &&
                            press.key != GLFW_KEY_SLASH && press.key != GLFW_KEY_ESCAPE;
        if (!meant_elsewhere && !flies && !behind) apply_key(press.key, press.modifiers, engine_->state(), edit_);
    }
    keys_.clear();
    for (const std::string& path : dropped_) edits::open(edit_, path);
    dropped_.clear();
}

void WindowLoop::apply_edit() {
    engine_->set_session(edit_.session);
    engine_->play(edit_.window.motion);
    edits::settle_motion(engine_->state(), edit_);
    if (!edit_.window.pinned) edit_.window.step.reset();
    engine_->select_triangle(edit_.window.triangle);
    engine_->set_probes(edit_.hovered, edit_.window.pinned, edit_.window.step);
    engine_->allow_duel(edit_.window.timing, edit_.window.timing_scale);
    edits::follow_ray(engine_->state(), edit_);
    engine_->select_node(edit_.window.node, shows(edit_, splits_panel));
    engine_->show_tree(edits::tree_wish(engine_->state(), edit_));
    engine_->keep_widths(shows(edit_, divergence_panel));
    engine_->keep_visits(shows(edit_, predicted_panel) || shows(edit_, nodes_panel));
    if (const auto& world = engine_->state().world; world && world != recent_world_) {
        if (recent_world_ && !same_scene(*recent_world_->loaded, *world->loaded)) edits::release(edit_);
        recent_world_ = world;
        add_recent(edit_.window.recent_files, world->loaded->name);
    }
    log_.applied(engine_->state().generation);
    if (!edit_.session_file.empty()) open_session();
    edits::settle_typed(engine_->state(), edit_);
    for (const Action action : edit_.actions) carry_out(action);
}

void WindowLoop::carry_out(Action action) {
    switch (action) {
        case Action::export_window: window_export_ = true; break;  // when the frame is drawn
        case Action::copy_camera: copy_camera(); break;
        case Action::paste_camera: paste_camera(); break;
        case Action::copy_ray: copy_ray(); break;
        default:
            if (!edits::carry_out(action, edit_, *engine_)) write_files(action);
    }
}

void WindowLoop::copy_camera() {
    const EngineState& state = engine_->state();
    if (!state.world) return;
    const Camera camera = to_scene_units(state.world->scene(), state.camera);
    glfwSetClipboardString(window_.handle(), camera_text(camera).c_str());
    engine_->say(false, "copied the camera");
}

void WindowLoop::copy_ray() {
    const EngineState& state = engine_->state();
    const std::optional<PixelReading>& reading = state.pinned ? state.pinned : state.hovered;
    if (!reading || !reading->oracle) return;
    glfwSetClipboardString(window_.handle(), rays_csv({&reading->oracle->ray, 1}).c_str());
    engine_->say(false, "copied the ray, as a table that kdscope trace --rays reads");
}

void WindowLoop::paste_camera() {
    if (!engine_->state().world) return;
    const char* text = glfwGetClipboardString(window_.handle());
    try {
        Session session = engine_->state().session;
        session.camera = to_internal(engine_->state().world->scene(), parse_camera(text ? text : ""));
        engine_->set_session(session);
    } catch (const InputError& error) {
        engine_->say(true, error.what());
    }
    lively_frames_ = frames_after_input;
}

/// Once it is read nothing more is to be done about what was typed; of its scene a message tells.
void WindowLoop::open_session() {
    edit_.window.motion.playing = false;  // it is of one time
    engine_->play(edit_.window.motion);
    engine_->open_session(edit_.session_file);
    const EngineState& state = engine_->state();
    lively_frames_ = frames_after_input;
    if (state.refused && state.refused->name == edit_.session_file) return;
    edit_.window.scene_text.clear();
    edit_.window.scene_asked.clear();
    edit_.window.scene_awaited = false;
    edits::remember_view(edit_, state.session.view);
}

/// Of the state as it is now, whatever changes while the file is being written.
void WindowLoop::write_files(Action action) {
    if (!engine_->state().picture) return engine_->say(true, "nothing is written: there is no picture yet");
    const auto state = std::make_shared<const EngineState>(engine_->state());
    const auto window =
        std::make_shared<const Image<Rgba8>>(action == Action::export_window ? read_window() : Image<Rgba8>{});
    const char* what = action == Action::export_csv     ? "CSV"
                       : action == Action::export_json  ? "JSON"
                       : action == Action::save_session ? "session"
                                                        : "PNG";
    exporter_.add(what, home_long(edit_.window.folder),
                  [this, action, state, window](const auto& folder, const auto& progress) {
                      return action == Action::export_window ? export_window(*window, *state, folder)
                                                             : export_file(action, *state, folder, font_, progress);
                  });
    lively_frames_ = frames_after_input;
}

void WindowLoop::fetch_exports() {
    for (const Exporter::Done& done : exporter_.fetch()) {
        lively_frames_ = frames_after_input;
        edit_.export_error = done.error;
        if (!done.error.empty()) {
            engine_->say(true, done.error);
            continue;
        }
        edit_.last_export = home_short(done.path);
        const std::string made =
            done.made_folder.empty() ? "" : "made the folder " + home_short(done.made_folder) + "; ";
        engine_->say(false, made + "wrote " + edit_.last_export);
    }
    edit_.exporting = exporter_.progress();
}

Image<Rgba8> WindowLoop::read_window() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    Image<Rgba8> upside_down(width, height);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels.data());
    for (Rgba8& pixel : upside_down.pixels) pixel.a = 255;
    Image<Rgba8> image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = upside_down.at(x, height - 1 - y);
    return image;
}

}  // namespace kd
