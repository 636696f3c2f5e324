// A GLFW window, and a second OpenGL context for the thread that traces.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/layout.h"
#include "renderer/gl/context.h"

struct GLFWwindow;

namespace kd {

/// Opens GLFW and a window; everything in here is for the main thread unless said otherwise.
class GlfwWindow {
  public:
    /// As large as `size`, or as suits the screen where that is empty. NoDisplay where GLFW finds no display or no
    /// OpenGL.
    GlfwWindow(const std::string& title, WindowSize size, bool maximised);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    /// Of the display: 1 on ordinary ones, 2 on dense ones. $KDSCOPE_SCALE overrides it.
    [[nodiscard]] float content_scale() const;
    [[nodiscard]] WindowSize size() const;
    [[nodiscard]] bool maximised() const;
    /// Minimised or not mapped: nobody sees it. (What lies behind other windows is not known.)
    [[nodiscard]] bool hidden() const;

    /// Opens a GL >= 4.3 context that shares nothing with the window's; to be called on the thread that will use it,
    /// and let go on that thread; called again where the one before was lost. ContextError where there is none.
    [[nodiscard]] std::function<std::unique_ptr<Context>()> tracing_context() const;

  private:
    GLFWwindow* window_ = nullptr;
    GLFWwindow* tracing_ = nullptr;  // invisible; null where GL 4.3 is missing
    std::string refused_;            // why tracing_ is null
};

}  // namespace kd
