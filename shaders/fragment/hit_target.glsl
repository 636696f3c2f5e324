// Hit and counters of a pass, one texel per pixel. Bits travel in integer targets: no driver touches them on the way.

#include "shaded.glsl"

layout(location = 2) out uvec4 out_hit; // triangle, and the bits of t, u, v
#if KD_COUNTERS
layout(location = 0) out uvec4 out_counters_a; // interior_first, interior_again, leaves, triangle_tests
layout(location = 1) out uvec4 out_counters_b; // restarts, backtracks, stack_depth, exit_reason and rays
#if KD_LATER_BOUNCE
layout(binding = 13) uniform usampler2D kd_earlier_counters_a;
layout(binding = 14) uniform usampler2D kd_earlier_counters_b;
#endif
#endif

/// What a fragment shader does not write is undefined; pixels without work are culled before it runs, or do it all.
const bool keeps_what_is_cleared = false;

void leave_hit(int2 pixel, Hit hit)
{
    out_hit = pack_hit(hit);
}

/// Counters of a later bounce go on where the earlier ones stopped.
void begin_counters(int2 pixel)
{
#if KD_COUNTERS && KD_LATER_BOUNCE
    counters = unpack_counters(texelFetch(kd_earlier_counters_a, pixel, 0), texelFetch(kd_earlier_counters_b, pixel, 0));
#endif
}

void leave_counters(int2 pixel)
{
#if KD_COUNTERS
    check_loops();
    out_counters_a = first_counters();
    out_counters_b = second_counters();
#endif
}
