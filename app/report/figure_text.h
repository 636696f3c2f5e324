// What a figure says about itself: title, caption, and the text inside its file. One wording for window and commands.
#pragma once

#include <optional>
#include <string>

#include "app/session.h"
#include "renderer/io/png.h"

namespace kd {

/// How the frame of a figure came about.
struct FigureFacts {
    std::string scene;
    double time = 0, duration = 0;  // seconds of its motion; 0 where it does not move
    std::size_t triangles = 0;
    BuildConfig build;
    bool refitted = false;  // the tree has the planes of the one at time 0
    TraceConfig trace;
    EarlyZ early_z = EarlyZ::working;
    std::optional<Camera> camera;  // the scene's own where absent; in scene units
    unsigned seed = 1;
    TracerKind tracer = TracerKind::cpu;
    std::string renderer;
    bool software_gl = false;
    int width = 0, height = 0;
    double milliseconds = 0;
    std::string clock;  // that the time was read from; may be empty
    int samples = 0;    // of light, for each pixel at most
    double average_samples = 0;
};

/// "Interior nodes visited, primary rays", the splits where no map is shown, the scene where neither is.
/// Of more than one of the `samples` of light, a map shows sums.
[[nodiscard]] std::string title_of(const std::string& scene, const ViewConfig& view, int samples = 0);

/// All that was chosen and what it took, in one line; seldom changed settings only where they differ from the default.
[[nodiscard]] std::string caption_of(const FigureFacts& facts);

/// Title, caption, program, and settings to make the picture again: `session`, in scene units, showing `view`.
[[nodiscard]] PngText png_text(const std::string& title, const std::string& caption, const Session& session,
                               const ViewConfig& view);

}  // namespace kd
