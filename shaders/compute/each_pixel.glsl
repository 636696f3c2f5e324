// Runs a pass, run_pass(), which stands above: each invocation at its own pixel, or with KD_PERSISTENT (Aila and Laine 2009)
// at as many of the tile's as its group fetches until there are no more. Defines main().

#include "own_pixel.glsl"

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;

void run_at(int2 pixel)
{
#if KD_PHASE
    next_slot = ((pixel.y - frame.tile.y) * (frame.tile.z - frame.tile.x) + pixel.x - frame.tile.x) * frame.wave.y;
#endif
    run_pass(pixel);
}

#if KD_PERSISTENT && !KD_LISTED
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
        int2 pixel;
        int2 block = int2(int(group) % groups.x, int(group) / groups.x);
        if (pixel_of_tile(block, gl_LocalInvocationIndex, pixel)) run_at(pixel);
    }
}
#else
void main()
{
    int2 pixel;
    if (own_pixel(gl_LocalInvocationIndex, pixel)) run_at(pixel);
}
#endif
