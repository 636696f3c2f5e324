// How much of a GPU a kind of shaders uses. Some run fragment shaders on a few of their multiprocessors only.
#pragma once

#include <optional>

#include "renderer/gl/gl_api.h"
#include "renderer/gl/gl_mode.h"

namespace kd {

struct Multiprocessors {
    int used = 0;   // different ones that worked at a picture
    int there = 0;  // of the GPU
};

/// Runs a shader of this kind over width x height pixels and asks each on which multiprocessor it is. Empty where the
/// driver does not tell (GL_NV_shader_thread_group). GlError where it refuses the shader; the context must be current.
[[nodiscard]] std::optional<Multiprocessors> multiprocessors_used(const GlApi& gl, GlMode mode, int width, int height);

}  // namespace kd
