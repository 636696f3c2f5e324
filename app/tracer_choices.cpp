#include "app/tracer_choices.h"

#include <fmt/format.h>

#include "app/choices.h"
#include "renderer/trace/walk_choices.h"

namespace kd {

std::string summary_of(TracerKind tracer) {
    using enum TracerKind;
    switch (tracer) {
        case cpu: return "The shared text as C++, a ray and a triangle at a time, on all cores.";
        case cpu_wide: return "The same walks on the CPU, with eight triangles of a leaf at a time.";
        case cpu_packet: return "Packets of rays walk together on the CPU while they agree (Wald et al. 2001).";
        case gl_fragment:
            return "The shared text as GLSL: RTPrim, ShadePrim, RTRefl and ShadeRefl draw one quad each, with the tree "
                   "in textures.";
        case gl_compute:
            return "The same four passes as compute shaders, with the tree in the same textures "
                   "(KDSCOPE_COMPUTE=8x8,storage puts it into storage buffers).";
        case gl_wavefront:
            return "Small kernels with the state of every ray in buffers (Purcell et al. 2002): the design that the "
                   "paper argues against.";
    }
    return "";
}

std::string tracer_text(TracerKind tracer, const TraceConfig& config) {
    const bool packets = tracer == TracerKind::cpu_packet && why_idle(WalkChoice::packet, config).empty();
    return fmt::format("{}{}", name_of(tracer), packets ? fmt::format(" of {}", config.packet_size) : "");
}

std::string why_idle(TracerChoice choice, TracerKind tracer) {
    const bool cpu = runs_on_cpu(tracer);
    const std::string no_gl = cpu ? "only the CPU traces; --tracer gl-fragment would use it" : "";
    using enum TracerChoice;
    switch (choice) {
        case threads:
            return cpu ? "" : fmt::format("{} traces, the CPU does not; --tracer cpu would use it", name_of(tracer));
        case context: return no_gl;
        case early_z:
            if (cpu || tracer == TracerKind::gl_fragment) return no_gl;
            return fmt::format("{} has no depth test to cull by; --tracer gl-fragment would use it", name_of(tracer));
        case count_shaded:
            if (tracer != TracerKind::gl_wavefront) return no_gl;
            return "the kernels of gl-wavefront shade no pixels of a pass; --tracer gl-fragment counts them";
        case packet:
            if (tracer == TracerKind::cpu_packet) return "";
            return fmt::format("{} walks no packets; --tracer cpu-packet does", name_of(tracer));
        case leaf_lists:
            if (!cpu || tracer == TracerKind::cpu) return "";
            return fmt::format("{} keeps leaves in blocks of its own; --tracer cpu would use it", name_of(tracer));
    }
    return "";
}

std::string why_no_walk(TracerKind tracer, const TraceConfig& config) {
    if (runs_on_cpu(tracer) || has_walk(gl_mode(tracer), config)) return "";
    return fmt::format("{} walks step by step: down the tree, under robust rules", name_of(tracer));
}

}  // namespace kd
