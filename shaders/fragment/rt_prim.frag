#define KD_WRITES_DEPTH
#include "tracer.glsl"
#include "hit_target.glsl"
#include "opengl/path_io.glsl"
#include "depth.glsl"
#include "opengl/rt_prim.glsl"

void main()
{
    run_pass(this_pixel());
}
