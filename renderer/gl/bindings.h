// Binding points of the shaders: the numbers in tables.glsl and the ..._target.glsl of shaders/fragment and
// shaders/compute, and in attributes.glsl, path_io.glsl and words.glsl of shaders/opengl.
#pragma once

namespace kd {

/// Texture units; for compute shaders the first five are storage buffers too. 16 are sure to exist in a shader.
enum class Unit : unsigned {
    nodes,
    boxes,
    references,
    leaf_corners,
    corners,
    material_index,
    normals,
    texture_coordinates,
    tables,
    texels,
    path_hit,
    path_direction,
    path_weight,
    earlier_counters_a,
    earlier_counters_b,
    earlier_hit,
    rays = path_hit,     // rays.glsl has no path
    entries = path_hit,  // nor has rt_prim.glsl
};

// Storage buffers behind the tables; the rays are of shaders/wavefront.
inline constexpr unsigned pixel_list = 5;       // shaders/compute/pixel_list.glsl
inline constexpr unsigned next_pixel_list = 6;  // shaders/compute/list_pixels.glsl
inline constexpr unsigned ray_states = 5;
inline constexpr unsigned queue_counts = 6;
inline constexpr unsigned ray_queues = 7;

inline constexpr unsigned scene_block = 0;  // uniform buffers
inline constexpr unsigned frame_block = 1;
inline constexpr unsigned counts_buffer = 0;  // atomic counter buffer

/// Draw buffers, and colour attachments with them; image units of compute shaders.
enum class Output : unsigned { counters_a, counters_b, hit, colour, direction = colour, weight };
inline constexpr unsigned output_count = 5;

}  // namespace kd
