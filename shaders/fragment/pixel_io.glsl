// What passes leave for each other and for the host, one texel per pixel. Bits travel in integer targets: no driver
// touches them on the way.

layout(location = 2) out uvec4 out_hit; // triangle, and the bits of t, u, v

uvec4 pack_hit(Hit hit)
{
    return uvec4(uint(hit.triangle), floatBitsToUint(hit.t), floatBitsToUint(hit.u), floatBitsToUint(hit.v));
}

Hit unpack_hit(uvec4 texel)
{
    return Hit(int(texel.x), uintBitsToFloat(texel.y), uintBitsToFloat(texel.z), uintBitsToFloat(texel.w));
}

#if KD_COUNTERS
layout(location = 0) out uvec4 out_counters_a; // interior_first, interior_again, leaves, triangle_tests
layout(location = 1) out uvec4 out_counters_b; // restarts, backtracks, stack_depth, exit_reason
#if KD_LATER_BOUNCE
layout(binding = 13) uniform usampler2D kd_earlier_counters_a;
layout(binding = 14) uniform usampler2D kd_earlier_counters_b;
#endif
#endif

/// Counters of a later bounce go on where the earlier ones stopped.
void begin_counters(int2 pixel)
{
#if KD_COUNTERS && KD_LATER_BOUNCE
    uvec4 a = texelFetch(kd_earlier_counters_a, pixel, 0);
    uvec4 b = texelFetch(kd_earlier_counters_b, pixel, 0);
    counters = RayCounters(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
#endif
}

void write_counters()
{
#if KD_COUNTERS
    check_loops();
    out_counters_a =
        uvec4(counters.interior_first, counters.interior_again, counters.leaves, counters.triangle_tests);
    out_counters_b = uvec4(counters.restarts, counters.backtracks, counters.stack_depth, counters.exit_reason);
#endif
}
