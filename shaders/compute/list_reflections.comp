// The pixels whose paths RTRefl continues and ShadeRefl shades. Others are told here that their path has ended.
#include "tracer.glsl"
#include "hit_target.glsl"
#include "path_target.glsl"
#include "opengl/path_io.glsl"

bool in_list(int2 pixel)
{
    bool has_work = goes_on(path_before_bounce(pixel));
    if (!has_work) end_path(pixel);
    return has_work;
}

#include "list_pixels.glsl"
