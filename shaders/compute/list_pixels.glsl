// Lists the pixels for which in_list() holds, which stands above, among those of the tile, or with KD_LISTED among those of
// the list before; defines main(). An invocation has several places of its group, so that neither shared memory nor an atomic
// for each pixel is needed, which llvmpipe runs lane by lane. Its pixels stay side by side in the list.

#include "own_pixel.glsl"

layout(local_size_x = KD_GROUP_X) in;
const uint places_each = uint(KD_GROUP_Y);

/// As PixelList.
layout(std430, binding = 6) restrict buffer NextPixelList {
    uint kd_next_groups[3];
    uint kd_next_listed;
    uint kd_next_runs; // of neighbours in a group: invocations that have listed any
    uint kd_next_pixels[];
};

/// How many groups so many places fill.
uint groups_for(uint places)
{
    return (places + places_in_group - 1u) / places_in_group;
}

/// Makes room for so many pixels more, and lets the dispatch reach over them; returns where they begin.
uint append(uint count)
{
    uint begin = atomicAdd(kd_next_listed, count);
    atomicAdd(kd_next_runs, 1u);
    uint groups = groups_for(begin + count);
    if (groups > groups_for(begin)) {
        atomicMax(kd_next_groups[0], min((groups + dealt_to - 1u) / dealt_to * dealt_to, groups_in_a_row));
        atomicMax(kd_next_groups[1], (groups + groups_in_a_row - 1u) / groups_in_a_row);
    }
    return begin;
}

void main()
{
    uint pixels[places_each];
    uint count = 0u;
    for (uint i = 0u; i < places_each; ++i) {
        uint place = gl_LocalInvocationIndex * places_each + i;
        int2 pixel;
        if (own_pixel(place, pixel) && in_list(pixel)) pixels[count++] = uint(pixel.x) | uint(pixel.y) << 16;
    }
    if (count == 0u) return;
    uint begin = append(count);
    for (uint i = 0u; i < count; ++i) kd_next_pixels[begin + i] = pixels[i];
}
