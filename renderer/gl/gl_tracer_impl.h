// What a GlTracer holds. The parts: gl_tracer.cpp (upload, prepare), frame_passes.cpp (the passes; gl_tracer_draw.cpp
// and gl_tracer_compute.cpp run them, gl_tracer_wavefront.cpp those that are many kernels), gl_tracer_read.cpp (back to
// a Frame), gl_tracer_rays.cpp (rays from a table).
#pragma once

#include <optional>

#include "renderer/gl/compute_settings.h"
#include "renderer/gl/frame_targets.h"
#include "renderer/gl/list_fill.h"
#include "renderer/gl/pass_programs.h"
#include "renderer/gl/pass_timer.h"
#include "renderer/gl/pixel_list.h"
#include "renderer/gl/ray_queues.h"
#include "renderer/gl/scene_upload.h"

namespace kd {

/// The programs of a step of GlMode::wavefront: `walks` is false where it has no rays and `answer` does all.
struct WavefrontPrograms {
    bool walks = false;
    GLuint ask = 0, answer = 0;
    std::array<GLuint, 2> plan{}, walk{};
};

struct GlTracer::Impl {
    const GlApi& gl;
    GlMode mode;
    ComputeSettings compute;  // of compute shaders
    bool software;
    bool fused;  // fma() rounds once
    bool corrected_rounding = !software;
    GlLimits limits;
    std::int64_t storage_bytes = 0;  // of a storage buffer at most; 0 where nothing is kept in one
    ProgramCache programs;
    PassTimer timer;
    GlVertexArray no_vertices;  // a core context draws with one bound, even an empty one
    UniformBuffer<gl_blocks::FrameBlock> frame_block;
    gl_blocks::FrameBlock frame_values{};  // what was set last for a whole tile
    GlBuffer counts;                       // shaded pixels
    std::optional<SceneUpload> uploaded;
    FrameTargets targets;
    RayQueues queues;  // of GlMode::wavefront
    PixelList pixels;  // of GlMode::compute
    ListFill hits_fill;
    bool lists_pixels = false;
    std::function<void(int)> told_compiling;
    int compiling = 0;

    Impl(Context& context, GlMode how);

    /// GlError where nothing has been uploaded.
    [[nodiscard]] SceneUpload& scene();
    [[nodiscard]] SceneNeeds needs_of(const TraceConfig& config);
    [[nodiscard]] GLuint program(Step step, const ProgramSettings& settings);
    [[nodiscard]] ProgramSettings settings_of(const TraceConfig& config);
    void reset_counts() const;
    void draw_quad() const;
    /// Runs the compute program in use over so many pixels; what it stores can then be read in any way.
    void dispatch(int width, int height) const;

    [[nodiscard]] WavefrontPrograms wavefront_programs(Step step, ProgramSettings settings);
    /// A step over a tile of frame_values, in as many parts as its rays need.
    void run_wavefront(Step step, const ProgramSettings& settings, const Tile& tile);

    /// Tables and targets for a configuration; keeps what fits.
    void make_ready(const TraceConfig& config, int width, int height);
    void draw_tile(const GlTraceConfig& config, const PinholeCamera& camera, Tile tile, GlFrameReport& report);
};

/// Textures that a compute shader stores to, by Output; 0 for none.
using ImageSet = std::array<GLuint, output_count>;
void bind_images(const GlApi& gl, const ImageSet& images);

/// Binds `texture` for texelFetch.
void bind_texture(const GlApi& gl, Unit unit, const GlTexture& texture);

}  // namespace kd
