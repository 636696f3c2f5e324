// The tracer in a compute shader. For entry points to include first.

#include "opengl/words.glsl"
#include "tables.glsl"
#include "opengl/tracer.glsl"
