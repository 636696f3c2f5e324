// ShadePrim (paper, section 3.2.2): shades the primary hits, with one shadow ray per light.

#include "tracer.glsl"
#include "pixel_io.glsl"
#include "path_io.glsl"
#include "shaded.glsl"

layout(location = 3) out vec4 out_colour;

void main()
{
    count_shaded();
    Hit first_blocked = nothing_found();
    out_colour = vec4(shade_path(primary_path(this_pixel()), first_blocked), 1.0);
    out_hit = pack_hit(first_blocked);
    write_counters();
}
