// The C++ side of shaders/shared: the words that make GLSL text compile as C++, and the shared value types.
//
// kd::Ray, kd::Hit, ... are single precision. kd::f64 holds the same types in double, for the oracle.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#ifdef __FAST_MATH__
#error "kdscope needs IEEE arithmetic: build without -ffast-math (and -Ofast)"
#endif

#define OUT(T) T&
#define INOUT(T) T&
#define IN(T) const T&
#define PRECISE
#define AXIS(vector, axis) (&(vector).x)[axis]  // glm's own [] branches on the index
#ifdef KD_SANITIZED
#define KD_FN inline  // instrumented, everything in one function takes minutes to compile
#else
#define KD_FN [[gnu::always_inline]] inline
#endif
#define KD_CALL_FN [[gnu::noinline]] inline
#define KD_CONST(T) static constexpr T
#define IS_NAN(x) false          // in C++ a comparison with NaN fails by itself
#define KD_CORRECTED_ROUNDING 0  // C++ rounds quotients and roots to nearest
#define KD_FUSED 0               // not every processor has a fused multiply-add
#define KD_RARE(condition) __builtin_expect(!!(condition), 0)

namespace kd {

using uint = std::uint32_t;
using int2 = glm::ivec2;
using int3 = glm::ivec3;

#include "shaders/shared/counters.glsl"

#define KD_SHARED_SCALAR(T, DEKKER)                                                                                    \
    static constexpr T KD_DEKKER = DEKKER;                                                                             \
    using real = T;                                                                                                    \
    using real2 = glm::vec<2, T>;                                                                                      \
    using real3 = glm::vec<3, T>;                                                                                      \
    using real4 = glm::vec<4, T>;                                                                                      \
    inline T abs(T x) { return std::fabs(x); } /* glm's compares and selects: six instructions for one */              \
    inline real3 abs(const real3& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }                                        \
    using glm::floor;                                                                                                  \
    using glm::max;                                                                                                    \
    using glm::min;                                                                                                    \
    using glm::pow;                                                                                                    \
    using glm::sqrt;

inline namespace f32 {
KD_SHARED_SCALAR(float, 4097.0f)
#include "shaders/shared/constants.glsl"
#include "shaders/shared/types.glsl"
}  // namespace f32

namespace f64 {
KD_SHARED_SCALAR(double, 134217729.0)
#include "shaders/shared/constants.glsl"
#include "shaders/shared/types.glsl"
}  // namespace f64

#undef KD_SHARED_SCALAR

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;

}  // namespace kd
