#include "tracer.glsl"
#include "hit_target.glsl"
#include "path_target.glsl"
#include "opengl/path_io.glsl"
#include "opengl/rt_refl.glsl"

void main()
{
    run_pass(this_pixel());
}
