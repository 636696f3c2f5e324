// The words of the shared text, as GLSL. C++ has its own in renderer/geometry/shared_types.h.

#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define int2 ivec2
#define int3 ivec3
#define int4 ivec4
#define OUT(T) out T
#define INOUT(T) inout T
#define PRECISE precise
#define KD_FN
#define KD_CONST(T) const T
#define KD_RARE(condition) (condition)
