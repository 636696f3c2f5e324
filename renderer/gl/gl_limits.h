// What a context can hold, and whether a scene and a configuration stay within it. No GL in it.
#pragma once

#include <cstdint>
#include <limits>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// Most steps (interior visits, leaves and triangle tests) of one ray in a shader; what needs more ends as
/// KD_EXIT_STEP_CAP.
inline constexpr int gl_step_budget = 60000;

/// llvmpipe ends loops after 65 535 rounds that all loops of a group of neighbouring invocations share. A walk takes up
/// to three rounds a step (a leaf is one of the walk's, and each loop has one more to find that it is done), and where
/// neighbours part, the rounds of each add up. So a ray among its like has this many steps for sure; one among others
/// can have fewer. check_loops() flags both as KD_EXIT_STEP_CAP. Other drivers leave gl_step_budget to all.
inline constexpr int gl_sure_steps = 65535 / 3;

struct GlLimits {
    std::int64_t buffer_texels = 65536;  // GL_MAX_TEXTURE_BUFFER_SIZE; the default is what OpenGL 4.3 guarantees
    std::int64_t texture_size = 16384;   // GL_MAX_TEXTURE_SIZE
    // GL_MAX_SHADER_STORAGE_BLOCK_SIZE where tables are read from storage buffers
    std::int64_t storage_bytes = std::numeric_limits<std::int64_t>::max();
};

// Of the table of materials, lights and images (shaders/opengl/scene_hooks.glsl).
inline constexpr int texels_per_material = 5, texels_per_light = 4;

/// What uploading asks for.
struct UploadSizes {
    std::int64_t nodes = 0, references = 0, triangles = 0, lights = 0, texels = 0, table_texels = 0;
};

[[nodiscard]] UploadSizes upload_sizes(const FlatScene& scene, const KdTree& tree);

/// InputError with the numbers where nodes, triangles, references or images do not fit the context.
void check_upload(const UploadSizes& sizes, const GlLimits& limits);

/// InputError with the numbers where what `config` needs beside that does not fit: numbers in float texels (up to
/// float_index_limit) of nodes of 16 bytes and of ropes, or in the 30 bits of nodes of 8; copied leaf lists, node
/// boxes, the loop budget of the naive traversal.
void check_config(const UploadSizes& sizes, const TraceConfig& config, const GlLimits& limits);

/// InputError for an image larger than a texture can be.
void check_image(int width, int height, const GlLimits& limits);

}  // namespace kd
