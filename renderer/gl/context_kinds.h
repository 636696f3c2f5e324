// The ways to make a context, one file each. All throw ContextError with the reason alone; Context::create adds the
// remedy.
#pragma once

#include <memory>

#include "renderer/gl/context.h"

namespace kd {

/// libOSMesa.so.8: llvmpipe without display or GPU. Removed from Mesa 25.1 on, so never the only way.
[[nodiscard]] std::unique_ptr<Context> make_osmesa_context();

/// Which of EGL's devices to try.
enum class EglDevices { hardware, software, hardware_first };

/// libEGL.so.1, no surface, device platform.
[[nodiscard]] std::unique_ptr<Context> make_egl_context(EglDevices devices);

/// OpenGL versions to ask for, best first.
struct GlVersion {
    int major, minor;
};
inline constexpr GlVersion gl_versions[] = {{4, 6}, {4, 5}, {4, 3}};

}  // namespace kd
