#include "viz/pixel_maps.h"

#include <cmath>
#include <limits>

#include "renderer/trace/counters.h"
#include "viz/divergence.h"

namespace kd::pixel_maps {

float nodes(const RayCounters& c, const Hit&) { return float(c.interior_first) + float(c.interior_again); }
float first_visits(const RayCounters& c, const Hit&) { return float(c.interior_first); }
float revisits(const RayCounters& c, const Hit&) { return float(c.interior_again); }
float leaves(const RayCounters& c, const Hit&) { return float(c.leaves); }
float triangles(const RayCounters& c, const Hit&) { return float(c.triangle_tests); }
float steps(const RayCounters& c, const Hit&) { return float(lane_steps(c)); }
float restarts(const RayCounters& c, const Hit&) { return float(c.restarts); }
float backtracks(const RayCounters& c, const Hit&) { return float(c.backtracks); }
float stack_depth(const RayCounters& c, const Hit&) { return float(c.stack_depth); }
float exit_reason(const RayCounters& c, const Hit&) { return float(c.exit_reason); }

float revisit_share(const RayCounters& c, const Hit& hit) {
    const float all = nodes(c, hit);
    return all > 0 ? float(c.interior_again) / all : std::numeric_limits<float>::quiet_NaN();
}

float distance(const RayCounters&, const Hit& hit) {
    if (hit.triangle < 0) return std::numeric_limits<float>::quiet_NaN();
    return std::isnan(hit.t) ? std::numeric_limits<float>::infinity() : hit.t;
}

void describe_exit(const Frame&, const MapConfig&, ScalarMap& map) {
    for (uint reason = KD_EXIT_MISS; reason <= KD_EXIT_INVALID_RAY; ++reason) {
        map.categories.emplace_back(exit_reason_name(reason));
    }
}

}  // namespace kd::pixel_maps
