// The pixels that ShadePrim shades.
#include "tracer.glsl"
#include "opengl/path_io.glsl"

bool in_list(int2 pixel)
{
    return int(texelFetch(kd_path_hit, pixel, 0).x) >= 0;
}

#include "list_pixels.glsl"
