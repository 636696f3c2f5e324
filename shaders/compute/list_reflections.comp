// The pixels whose paths RTRefl continues and ShadeRefl shades.
#include "tracer.glsl"
#include "opengl/path_io.glsl"

bool in_list(int2 pixel)
{
    return goes_on(path_before_bounce(pixel));
}

#include "list_pixels.glsl"
