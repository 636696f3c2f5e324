// What walks read, from texture buffers. Fragment shaders have no other tables: llvmpipe reads storage buffers wrongly
// there, on partly covered blocks of pixels. renderer/gl/bindings.h holds the same numbers.

#if KD_PACKED_NODES
layout(binding = 0) uniform usamplerBuffer kd_nodes;      // two words: split or count; kind and link
uvec2 node_words(int node) { return texelFetch(kd_nodes, node).xy; }
#else
layout(binding = 0) uniform samplerBuffer kd_nodes;       // the paper's texels: flag, split or count, link, parent
vec4 node_texel(int node) { return texelFetch(kd_nodes, node); }
#endif
layout(binding = 1) uniform samplerBuffer kd_boxes;       // two texels per node: lower, upper; then, if any, two of ropes
layout(binding = 2) uniform usamplerBuffer kd_references; // triangle numbers of 16 or 32 bits, leaf by leaf
layout(binding = 3) uniform samplerBuffer kd_leaf_corners; // three texels per entry of the leaf lists
layout(binding = 4) uniform samplerBuffer kd_corners;     // three texels per triangle

vec4 box_texel(int index) { return texelFetch(kd_boxes, index); }
int reference_at(int slot) { return int(texelFetch(kd_references, slot).x); }
real3 leaf_corner(int index) { return texelFetch(kd_leaf_corners, index).xyz; }
real3 corner_at(int index) { return texelFetch(kd_corners, index).xyz; }
