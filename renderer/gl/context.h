// An OpenGL context with no window, or the caller's own.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gl/gl_debug.h"

namespace kd {

/// No context of the kind asked for; what() says why and names the alternatives.
struct ContextError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class ContextKind { automatic, osmesa, egl, adopted };

/// "auto", "osmesa", "egl" as on the command line; "adopted" for a window's own.
[[nodiscard]] std::string_view name_of(ContextKind kind);

/// A GL >= 4.3 core context. libOSMesa and libEGL are loaded when needed and never linked.
class Context {
  public:
    /// auto = EGL on a hardware device, else OSMesa, else EGL on software. Current on return.
    [[nodiscard]] static std::unique_ptr<Context> create(ContextKind kind);

    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void make_current() = 0;

    [[nodiscard]] const GlApi& gl() const { return gl_; }
    [[nodiscard]] ContextKind kind() const { return kind_; }
    [[nodiscard]] const std::string& renderer() const { return renderer_; }  // GL_RENDERER
    [[nodiscard]] const std::string& version() const { return version_; }    // GL_VERSION
    /// llvmpipe, softpipe, swrast: timer queries mean nothing there.
    [[nodiscard]] bool is_software() const { return software_; }

  protected:
    explicit Context(ContextKind kind) : kind_(kind) {}
    void load(GlApi::GetProc load);  // fills gl_, renderer_, version_, software_; ContextError below GL 4.3

  private:
    ContextKind kind_;
    GlApi gl_;
    GlMessages messages_;
    std::string renderer_, version_;
    bool software_ = false;
};

}  // namespace kd
