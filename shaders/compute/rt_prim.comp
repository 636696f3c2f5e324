#include "tracer.glsl"
#include "hit_target.glsl"
#include "opengl/path_io.glsl"

void leave_depth(Path path) {}

#include "opengl/rt_prim.glsl"
#include "each_pixel.glsl"
