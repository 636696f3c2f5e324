// What kind of shaders a GlTracer runs.
#pragma once

#include <array>
#include <string_view>

namespace kd {

struct TraceConfig;  // renderer/trace/trace_config.h

enum class GlMode {
    fragment,  // the paper's four passes as screen-aligned quads, data in textures
    compute,   // the same passes as compute shaders, data in textures, or in storage buffers where KDSCOPE_COMPUTE says
    wavefront,  // small kernels with the state of every ray in buffers (Purcell, Buck, Mark, Hanrahan 2002)
};

inline constexpr std::array gl_modes{GlMode::fragment, GlMode::compute, GlMode::wavefront};

/// "gl-fragment", "gl-compute", "gl-wavefront".
[[nodiscard]] constexpr std::string_view tracer_name(GlMode mode) {
    constexpr std::array<std::string_view, 3> names{"gl-fragment", "gl-compute", "gl-wavefront"};
    return names[static_cast<std::size_t>(mode)];
}

/// Whether shaders of this kind can trace `config`: "gl-wavefront" has the walks that go step by step, those of the
/// tree under robust rules.
[[nodiscard]] bool has_walk(GlMode mode, const TraceConfig& config);

}  // namespace kd
