// The tracer in a fragment shader. For entry points to include first.

#include "opengl/words.glsl"
#include "opengl/texture_tables.glsl"
#include "opengl/tracer.glsl"

/// Image row r from the top is row r of the targets; whoever displays them turns them over.
int2 this_pixel()
{
    return int2(gl_FragCoord.xy);
}
