// The walks in double precision; a file of its own, for the compiler's sake.

#include <limits>

#include "renderer/measure/error_time/walks.h"
#include "renderer/trace/observer.h"

namespace kd::f64 {

namespace {
#include "renderer/measure/error_time/walks.inc"
}  // namespace

void walk_in_double(const WalkScene& scene, const HitMethod& method, std::span<const kd::Ray> rays,
                    std::span<HitAnswer> answers);

void walk_in_double(const WalkScene& scene, const HitMethod& method, std::span<const kd::Ray> rays,
                    std::span<HitAnswer> answers) {
    walk(scene, method, rays, answers);
}

}  // namespace kd::f64
