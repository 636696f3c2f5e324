// RTRefl (paper, section 3.2.3): traces the mirror rays of paths that go on. Leaves a path of zero weight elsewhere.

#include "tracer.glsl"
#include "pixel_io.glsl"
#include "path_io.glsl"
#include "shaded.glsl"

layout(location = 3) out vec4 out_direction;
layout(location = 4) out vec4 out_weight;

void main()
{
    count_shaded();
    int2 pixel = this_pixel();
    begin_counters(pixel);
#if KD_LATER_BOUNCE
    Path path = reflected_path(pixel);
#else
    Path path = primary_path(pixel);
#endif
    Path next = path;
    next.hit = nothing_found();
    next.weight = real3(0, 0, 0);
    // Depth has culled the other pixels already, unless drawn as published.
    if (goes_on(path)) next = trace_reflection(path);
    out_hit = pack_hit(next.hit);
    out_direction = vec4(next.ray.direction, 0.0);
    out_weight = vec4(next.weight, 0.0);
    write_counters();
}
