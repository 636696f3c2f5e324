// How compute shaders are run: what a machine may be asked to do otherwise than measurements elsewhere have found best.
#pragma once

#include <optional>
#include <string_view>

namespace kd {

struct ComputeSettings {
    // A work group's pixels each way. Software renderers of 8 lanes need x to be a multiple of 8: where a row of a
    // group leaves lanes empty, llvmpipe lets these loop as long as it lets any.
    int x = 8, y = 8;
    // In Morton order, so that lanes that run side by side are a block however wide the group is: 4x2 on llvmpipe, 8x4
    // on GPUs.
    bool morton = true;
    // Nodes, leaf lists and triangles from storage buffers; else from textures, which llvmpipe and an H100 read faster.
    bool storage = false;

    // Rows of groups dealt in turn to the threads of a software renderer, or in order; empty: dealt on llvmpipe, which
    // gives each thread one run of groups.
    std::optional<bool> dealt = {};

    // Shading and reflections over lists of the pixels that have work, or over all pixels; empty: over lists on
    // llvmpipe, which runs a pass to its end where no lane has work.
    std::optional<bool> lists = {};

    bool operator==(const ComputeSettings&) const = default;
};

/// "16x8", "16x16,linear", "8x4,storage", "8x8,textures,lists", "8x8,no-lists,in-order"; "16x8" is in Morton order
/// where that fills it. InputError with one line where it is none of these, or where a group has more than 1024 pixels
/// (what OpenGL 4.3 promises).
[[nodiscard]] ComputeSettings parse_compute_settings(std::string_view text);

/// What the environment variable KDSCOPE_COMPUTE says, the default where it is not set.
[[nodiscard]] ComputeSettings compute_settings_in_force();

}  // namespace kd
