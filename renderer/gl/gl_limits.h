// What a context can hold, and whether a scene and a configuration stay within it. No GL in it.
#pragma once

#include <cstdint>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// Steps (interior visits, leaves and triangle tests) of one ray in a shader. llvmpipe ends loops without a word after
/// 65 535 iterations, which all loops of a shader invocation share.
inline constexpr int gl_step_budget = 60000;

struct GlLimits {
    std::int64_t buffer_texels = 65536;  // GL_MAX_TEXTURE_BUFFER_SIZE; the default is what OpenGL 4.3 guarantees
    std::int64_t texture_size = 16384;   // GL_MAX_TEXTURE_SIZE
};

/// What uploading asks for.
struct UploadSizes {
    std::int64_t nodes = 0, references = 0, triangles = 0, lights = 0, texels = 0, table_texels = 0;
};

[[nodiscard]] UploadSizes upload_sizes(const FlatScene& scene, const KdTree& tree);

/// InputError with the numbers where nodes, triangles, references or images do not fit the context or the float4 texels
/// (whole numbers up to float_index_limit).
void check_upload(const UploadSizes& sizes, const GlLimits& limits);

/// InputError with the numbers where what `config` needs beside the upload does not fit: copied leaf lists, node boxes,
/// the loop budget of the naive traversal.
void check_config(const UploadSizes& sizes, const TraceConfig& config, const GlLimits& limits);

/// InputError for an image larger than a texture can be.
void check_image(int width, int height, const GlLimits& limits);

}  // namespace kd
