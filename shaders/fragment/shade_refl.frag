// ShadeRefl (paper, section 3.2.3): light along the mirror rays, added to the picture by blending.

#include "tracer.glsl"
#include "pixel_io.glsl"
#include "path_io.glsl"
#include "shaded.glsl"

layout(location = 3) out vec4 out_colour;

#if KD_LATER_BOUNCE && KD_SHADOWS
layout(binding = 15) uniform usampler2D kd_earlier_hit;
#endif

void main()
{
    count_shaded();
    int2 pixel = this_pixel();
    begin_counters(pixel);
    Hit first_blocked = nothing_found();
#if KD_LATER_BOUNCE && KD_SHADOWS
    first_blocked = unpack_hit(texelFetch(kd_earlier_hit, pixel, 0));
#endif
    Path path = reflected_path(pixel);
    out_colour = vec4(0.0);
    // Depth has culled the other pixels already, unless drawn as published.
    if (max_component(path.weight) > 0.0) out_colour.xyz = shade_path(path, first_blocked);
    out_hit = pack_hit(first_blocked);
    write_counters();
}
