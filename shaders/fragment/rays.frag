#include "tracer.glsl"
#include "hit_target.glsl"
#include "opengl/ray_io.glsl"
#include "opengl/rays.glsl"

void main()
{
    run_pass(this_pixel());
}
