// Binding points of the fragment shaders: the numbers in shaders/fragment/bindings.glsl, path_io.glsl and
// pixel_io.glsl.
#pragma once

namespace kd {

/// Texture units. 16 are sure to exist in a fragment shader.
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
    rays = path_hit,     // rays.frag has no path
    entries = path_hit,  // nor has rt_prim.frag
};

inline constexpr unsigned scene_block = 0;  // uniform buffers
inline constexpr unsigned frame_block = 1;
inline constexpr unsigned shaded_counter = 0;  // atomic counter buffer

/// Draw buffers, and colour attachments with them.
enum class Output : unsigned { counters_a, counters_b, hit, colour, direction = colour, weight };
inline constexpr unsigned output_count = 5;

}  // namespace kd
