// The pixels that later passes work at, in place of the depth that culls fragments: a list and the dispatch over it.
// renderer/gl/pixel_list.cpp knows the layout. Pixels of one group stand side by side, in the group's order.

layout(std430, binding = 5) restrict buffer PixelList {
    uint kd_groups[3]; // of glDispatchComputeIndirect: rows of groups_in_a_row
    uint kd_listed;
    uint kd_pixels[]; // column in the low 16 bits, row in the high ones
};

const uint groups_in_a_row = 1024u; // OpenGL promises 65 535 each way
