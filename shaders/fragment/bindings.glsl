// Where the tables of scene and tree are bound. renderer/gl/bindings.h holds the same numbers.

layout(std140, binding = 0) uniform SceneUniforms { SceneBlock scene; };
layout(std140, binding = 1) uniform FrameUniforms { FrameBlock frame; };

#if KD_PACKED_NODES
layout(binding = 0) uniform usamplerBuffer kd_nodes;          // two words: split or count; kind and link
#else
layout(binding = 0) uniform samplerBuffer kd_nodes;           // the paper's texels: flag, split or count, link, parent
#endif
layout(binding = 1) uniform samplerBuffer kd_boxes;           // two texels per node: lower, upper; then, if any, two of ropes
layout(binding = 2) uniform usamplerBuffer kd_references;     // triangle numbers of 16 or 32 bits, leaf by leaf
layout(binding = 3) uniform samplerBuffer kd_leaf_corners;    // three texels per entry of the leaf lists
layout(binding = 4) uniform samplerBuffer kd_corners;         // three texels per triangle
layout(binding = 5) uniform isamplerBuffer kd_material_index; // one per triangle
layout(binding = 6) uniform samplerBuffer kd_normals;         // three texels per triangle
layout(binding = 7) uniform samplerBuffer kd_uv;              // three texels per triangle
layout(binding = 8) uniform usamplerBuffer kd_tables;         // bits of materials (3 texels), lights (4), textures (1)
layout(binding = 9) uniform usamplerBuffer kd_texels;         // all textures, row by row, 8 bits per channel
