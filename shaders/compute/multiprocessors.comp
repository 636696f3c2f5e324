#include "opengl/multiprocessors.glsl"

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;
layout(rgba32ui, binding = 2) restrict writeonly uniform uimage2D kd_place;

void main()
{
    imageStore(kd_place, ivec2(gl_GlobalInvocationID.xy), this_place(gl_GlobalInvocationID.xy));
}
