// Everything a person has chosen. The window edits it, the command line fills it, a picture is made from it alone.
#pragma once

#include <optional>
#include <string>

#include "renderer/kdtree/build.h"
#include "renderer/scene/camera.h"
#include "renderer/trace/trace_config.h"
#include "viz/heatmap.h"
#include "viz/overlay.h"

namespace kd {

/// cpu = shared text on the CPU; gl_fragment = the four passes.
enum class TracerKind { cpu, gl_fragment };

struct ViewConfig {
    bool show_map = true;
    MapConfig map;
    HeatmapConfig heat{.opacity = 0.5f};
    OverlayConfig overlay;

    bool operator==(const ViewConfig&) const = default;
};

struct Session {
    std::string scene = "ball:9000"; // procedural name or file
    unsigned seed = 1;
    BuildConfig build;
    TraceConfig trace;
    TracerKind tracer = TracerKind::cpu;
    std::optional<Camera> camera; // the scene's own where absent
    ViewConfig view;
    int width = 512, height = 512;
    int threads = 0; // 0 = all

    bool operator==(const Session&) const = default;
};

/// A procedural scene or a glTF file. InputError.
[[nodiscard]] FlatScene load_scene(const std::string& name, unsigned seed);

} // namespace kd
