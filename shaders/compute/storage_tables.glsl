// What walks read, from storage buffers: the buffers that opengl/texture_tables.glsl sees through textures, at the same numbers.
// What shading reads stays in texture buffers, for OpenGL 4.3 promises a compute shader eight blocks of storage.

#if KD_PACKED_NODES
layout(std430, binding = 0) restrict readonly buffer Nodes { uvec2 kd_nodes[]; };
uvec2 node_words(int node) { return kd_nodes[node]; }
#else
layout(std430, binding = 0) restrict readonly buffer Nodes { vec4 kd_nodes[]; };
vec4 node_texel(int node) { return kd_nodes[node]; }
#endif
layout(std430, binding = 1) restrict readonly buffer Boxes { vec4 kd_boxes[]; };
layout(std430, binding = 2) restrict readonly buffer References { uint kd_references[]; };
layout(std430, binding = 3) restrict readonly buffer LeafCorners { vec4 kd_leaf_corners[]; };
layout(std430, binding = 4) restrict readonly buffer Corners { vec4 kd_corners[]; };

vec4 box_texel(int index) { return kd_boxes[index]; }
real3 leaf_corner(int index) { return kd_leaf_corners[index].xyz; }
real3 corner_at(int index) { return kd_corners[index].xyz; }

int reference_at(int slot)
{
#if KD_WIDE_REFERENCES
    return int(kd_references[slot]);
#else
    // Two to a word, the first in the lower half.
    return int(kd_references[slot >> 1] >> uint((slot & 1) << 4) & 0xffffu);
#endif
}
