// What shading reads, from texture buffers in every kind of shader; renderer/gl/bindings.h holds the same numbers.

layout(binding = 5) uniform isamplerBuffer kd_material_index; // one per triangle
layout(binding = 6) uniform samplerBuffer kd_normals;         // three texels per triangle
layout(binding = 7) uniform samplerBuffer kd_uv;              // three texels per triangle
layout(binding = 8) uniform usamplerBuffer kd_tables;         // bits of materials (5 texels each), lights (4), textures (1)
layout(binding = 9) uniform usamplerBuffer kd_texels;         // all images, row by row, 8 bits per channel
