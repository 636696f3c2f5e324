// A quad that fits the screen exactly, as a strip of four vertices. (One oversized triangle would be clipped into two
// with a seam, and the pixels on it shaded twice in half-covered groups.)

#include "opengl/settings.glsl"

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    gl_Position = vec4(corner, KD_QUAD_DEPTH * 2.0 - 1.0, 1.0);
}
