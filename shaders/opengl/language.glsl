// The words of the shared text, as GLSL. C++ has its own in renderer/geometry/shared_types.h.

#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define int2 ivec2
#define int3 ivec3
#define int4 ivec4
#define IN(T) const in T
#define OUT(T) out T
#define INOUT(T) inout T
#define AXIS(vector, axis) (vector)[axis]
#define PRECISE precise
#define KD_FN
#define KD_CALL_FN // a call even where C++ puts all else into one function: long, and few rays come there
#define KD_CONST(T) const T
// By its bits: GLSL compilers may assume that no comparison sees a NaN.
#define IS_NAN(x) ((floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u)
#define KD_RARE(condition) (condition)
#define KD_DEKKER 4097.0
