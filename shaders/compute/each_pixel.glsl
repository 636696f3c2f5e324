// Which pixels an invocation works at: one of the tile, with KD_LISTED one of a list, or with KD_PERSISTENT (Aila and Laine
// 2009) as many as its group fetches until the tile has no more. Defines main(); run_pass() stands above.

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;

#if KD_LISTED
#include "pixel_list.glsl"

void main()
{
    uint group = gl_WorkGroupID.y * groups_in_a_row + gl_WorkGroupID.x;
    uint place = group * uint(KD_GROUP_X * KD_GROUP_Y) + gl_LocalInvocationIndex;
    if (place >= kd_listed) return;
    uint pixel = kd_pixels[place];
    run_pass(int2(pixel & 0xffffu, pixel >> 16));
}

#else
#include "place_in_group.glsl"

void run_in_tile(int2 group)
{
    int2 pixel = frame.tile.xy + group * int2(KD_GROUP_X, KD_GROUP_Y) + place_in_group();
    if (pixel.x >= frame.tile.z || pixel.y >= frame.tile.w) return;
#if KD_PHASE
    next_slot = ((pixel.y - frame.tile.y) * (frame.tile.z - frame.tile.x) + pixel.x - frame.tile.x) * frame.wave.y;
#endif
    run_pass(pixel);
}

#if KD_PERSISTENT
layout(binding = 0, offset = 4) uniform atomic_uint groups_taken;
shared uint taken;

void main()
{
    int2 groups = (frame.tile.zw - frame.tile.xy + int2(KD_GROUP_X - 1, KD_GROUP_Y - 1)) / int2(KD_GROUP_X, KD_GROUP_Y);
    uint count = uint(groups.x * groups.y);
    RayCounters none = counters;
    while (true) {
        barrier(); // all have read what was taken before
        if (gl_LocalInvocationIndex == 0u) taken = atomicCounterIncrement(groups_taken);
        memoryBarrierShared();
        barrier();
        uint group = taken;
        if (group >= count) return;
        counters = none;
        run_in_tile(int2(int(group) % groups.x, int(group) / groups.x));
    }
}
#else
void main()
{
    run_in_tile(int2(gl_WorkGroupID.xy));
}
#endif
#endif
