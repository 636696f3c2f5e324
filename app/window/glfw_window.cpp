#include "app/window/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/environment.h"

namespace kd {

namespace {

constexpr int least_width = 960, least_height = 600;
constexpr float least_scale = 0.75f, largest_scale = 4;  // of what a display may ask for

/// The context of a window that nobody sees. Current from its making to its end, on one thread.
class HiddenContext final : public Context {
  public:
    explicit HiddenContext(GLFWwindow* window) : Context(ContextKind::adopted), window_(window) {
        HiddenContext::make_current();
        load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
    }
    ~HiddenContext() override { glfwMakeContextCurrent(nullptr); }
    HiddenContext(const HiddenContext&) = delete;
    HiddenContext& operator=(const HiddenContext&) = delete;

    void make_current() override { glfwMakeContextCurrent(window_); }

  private:
    GLFWwindow* window_;
};

std::string glfw_error() {
    const char* text = nullptr;
    return glfwGetError(&text) != GLFW_NO_ERROR && text ? text : "GLFW gives no reason";
}

/// The display's scale, or what the environment says instead.
float chosen_scale(float scale) { return environment_scale().value_or(std::clamp(scale, least_scale, largest_scale)); }

/// The wanted size kept to the screen's free area, or what suits that where none is wanted.
WindowSize size_for_screen(WindowSize wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return wanted == WindowSize{} ? WindowSize{1280, 720} : wanted;
    int x = 0, y = 0;
    WindowSize free;
    float across = 1, down = 1;
    glfwGetMonitorWorkarea(monitor, &x, &y, &free.width, &free.height);
    glfwGetMonitorContentScale(monitor, &across, &down);
    if (wanted != WindowSize{}) return {std::min(wanted.width, free.width), std::min(wanted.height, free.height)};
    return first_size(free, chosen_scale(std::max(across, down)));
}

/// The first of the versions that there is; null where none is.
GLFWwindow* try_versions(const std::string& title, int width, int height,
                         std::initializer_list<std::pair<int, int>> versions) {
    for (const auto& [major, minor] : versions) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr)) return window;
    }
    return nullptr;
}

[[noreturn]] void refuse(const std::string& what) {
    const std::string reason = glfw_error();
    glfwTerminate();
    throw NoDisplay(what + ": " + reason + "; `kdscope render SCENE -o F.png` makes pictures without a window");
}

}  // namespace

GlfwWindow::GlfwWindow(const std::string& title, WindowSize size, bool maximised) {
    if (!glfwInit()) refuse("cannot open a window");
    size = size_for_screen(size);  // it may be of another screen
    glfwWindowHint(GLFW_MAXIMIZED, maximised ? GLFW_TRUE : GLFW_FALSE);
    window_ = try_versions(title, size.width, size.height, {{4, 3}, {3, 3}});
    if (!window_) refuse("cannot open a window with OpenGL 3.3");
    glfwSetWindowSizeLimits(window_, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);

    glfwWindowHint(GLFW_MAXIMIZED, GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
        glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
        if (!tracing_) tracing_ = try_versions(title + ": tracing", 16, 16, {{4, 6}, {4, 5}, {4, 3}});
    }
    if (!tracing_) refused_ = "OpenGL 4.3 is not there: " + glfw_error();
}

GlfwWindow::~GlfwWindow() {
    if (tracing_) glfwDestroyWindow(tracing_);
    glfwDestroyWindow(window_);
    glfwTerminate();
}

float GlfwWindow::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return chosen_scale(std::max(x, y));
}

WindowSize GlfwWindow::size() const {
    WindowSize size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    return size;
}

bool GlfwWindow::hidden() const {
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE ||
           glfwGetWindowAttrib(window_, GLFW_VISIBLE) != GLFW_TRUE;
}

bool GlfwWindow::maximised() const { return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE; }

std::function<std::unique_ptr<Context>()> GlfwWindow::tracing_context() const {
    return [window = tracing_, why = refused_]() mutable -> std::unique_ptr<Context> {
        if (!why.empty()) throw ContextError(why);
        // GLFW makes contexts on the main thread alone, so one that was lost is replaced by one without a window.
        if (!window) return Context::create(ContextKind::automatic);
        return std::make_unique<HiddenContext>(std::exchange(window, nullptr));
    };
}

}  // namespace kd
