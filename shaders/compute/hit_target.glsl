// Hit and counters of a pass, one texel per pixel, as fragment/hit_target.glsl leaves them.

layout(rgba32ui, binding = 2) restrict uniform uimage2D kd_hit; // triangle, and the bits of t, u, v
#if KD_COUNTERS
layout(rgba32ui, binding = 0) restrict uniform uimage2D kd_counters_a;
layout(rgba32ui, binding = 1) restrict uniform uimage2D kd_counters_b;
#endif
#if KD_COUNT_SHADED
layout(binding = 0, offset = 0) uniform atomic_uint shaded_pixels;
#endif

// A pass that only asks for its rays has nothing to leave yet.
#if KD_PHASE == 1
#define KD_STORE(image, pixel, texel)
#else
#define KD_STORE(image, pixel, texel) imageStore(image, pixel, texel)
#endif

/// What is not stored stays as it was cleared, or as an earlier bounce left it.
const bool keeps_what_is_cleared = true;

void leave_hit(int2 pixel, Hit hit)
{
    KD_STORE(kd_hit, pixel, pack_hit(hit));
}

/// Counters of a later bounce go on where the earlier ones stopped.
void begin_counters(int2 pixel)
{
#if KD_COUNTERS && KD_LATER_BOUNCE
    counters = unpack_counters(imageLoad(kd_counters_a, pixel), imageLoad(kd_counters_b, pixel));
#endif
}

void leave_counters(int2 pixel)
{
#if KD_COUNTERS
    check_loops();
    KD_STORE(kd_counters_a, pixel, first_counters());
    KD_STORE(kd_counters_b, pixel, second_counters());
#endif
}

/// No depth culls here: pixels without work are passed over by the shader. A list has culled before, and all it has counts.
void count_shaded(bool has_work)
{
#if KD_COUNT_SHADED && KD_PHASE != 1
    if (has_work || KD_LISTED == 1) atomicCounterIncrement(shaded_pixels);
#endif
}
