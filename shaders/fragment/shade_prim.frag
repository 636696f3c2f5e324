#include "tracer.glsl"
#include "hit_target.glsl"
#include "colour_target.glsl"
#include "opengl/path_io.glsl"
#include "opengl/shade_prim.glsl"

void main()
{
    run_pass(this_pixel());
}
