// The pixels that a pass works at, in place of the depth that culls fragments: a list and the dispatch over it.
// renderer/gl/pixel_list.cpp knows the layout.

const uint groups_in_a_row = 1024u; // OpenGL promises 65 535 each way; a multiple of dealt_to

#if KD_LISTED
layout(std430, binding = 5) restrict readonly buffer PixelList {
    uint kd_groups[3]; // of glDispatchComputeIndirect: rows of groups_in_a_row
    uint kd_listed;
    uint kd_runs;
    uint kd_pixels[]; // column in the low 16 bits, row in the high ones
};

/// False past the list's end.
bool listed_pixel(uint place, out int2 pixel)
{
    bool listed = place < kd_listed;
    uint word = listed ? kd_pixels[place] : 0u;
    pixel = int2(word & 0xffffu, word >> 16);
    return listed;
}
#endif
