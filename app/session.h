// Everything a person has chosen. The window edits it, the command line fills it, a picture is made from it alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_mode.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"
#include "viz/view_config.h"

namespace kd {

/// A machine and how it is used: every CpuMode, then every GlMode.
enum class TracerKind { cpu, cpu_wide, cpu_packet, gl_fragment, gl_compute, gl_wavefront };
[[nodiscard]] constexpr bool runs_on_cpu(TracerKind tracer) { return tracer < TracerKind::gl_fragment; }
/// Of a tracer that runs there.
[[nodiscard]] constexpr CpuMode cpu_mode(TracerKind tracer) { return CpuMode(tracer); }
[[nodiscard]] constexpr GlMode gl_mode(TracerKind tracer) { return GlMode(int(tracer) - int(TracerKind::gl_fragment)); }

struct Session {
    std::string scene = "ball:9000";  // procedural name or file
    unsigned seed = 1;
    double time = 0.0;  // in seconds, of the scene's motion, which repeats; nothing to a scene that does not move
    BuildConfig build;
    TraceConfig trace;
    TracerKind tracer = TracerKind::cpu;
    EarlyZ early_z = EarlyZ::working;  // of the four passes
    std::optional<Camera> camera;      // the scene's own where absent; in the scene's internal units
    ViewConfig view;
    int width = 512, height = 512;
    int threads = 0;         // 0 = all
    int samples = 0;         // of light, for each pixel at most; 0: the paper's one ray towards each light
    float sample_error = 0;  // standard error at which tiles stop before; 0: none does

    bool operator==(const Session&) const = default;
};

/// How the first frame is traced, and the only one where light is not sampled.
[[nodiscard]] TraceConfig first_sample(const Session& session);

/// The session with its camera and its planes by hand in scene units, as people and files have them; here they are in
/// the scene's internal ones.
[[nodiscard]] Session in_scene_units(Session session, const FlatScene& scene);

/// Planes in scene units as the scene's tree has them.
[[nodiscard]] std::vector<HandSplit> to_internal(const FlatScene& scene, std::vector<HandSplit> splits);

}  // namespace kd
