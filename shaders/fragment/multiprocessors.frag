#include "opengl/multiprocessors.glsl"

layout(location = 2) out uvec4 out_place;

void main()
{
    out_place = this_place(uvec2(gl_FragCoord.xy));
}
