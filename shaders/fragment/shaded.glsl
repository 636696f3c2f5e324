// Counts the pixels that are shaded, exactly. An atomic makes drivers test depth late unless told otherwise, and a shader
// that writes depth cannot be told (KD_WRITES_DEPTH).

#if KD_COUNT_SHADED
layout(binding = 0, offset = 0) uniform atomic_uint shaded_pixels;
#ifndef KD_WRITES_DEPTH
layout(early_fragment_tests) in;
#endif
#endif

/// Every pixel that depth has not culled counts, whether it then has work or not.
void count_shaded(bool has_work)
{
#if KD_COUNT_SHADED
    atomicCounterIncrement(shaded_pixels);
#endif
}
