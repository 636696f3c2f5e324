// Maps that look at one pixel at a time: the counters and the hit of its ray, or the sums over its rays.
#include <array>
#include <cmath>
#include <limits>

#include "renderer/trace/counters.h"
#include "viz/divergence.h"
#include "viz/map.h"

namespace kd {
namespace {

using enum MapInfo::Kind;

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

float nodes(const RayCounters& c) { return float(c.interior_first) + float(c.interior_again); }

void name_exit_reasons(const Frame&, const MapConfig&, ScalarMap& map) {
    for (uint reason = KD_EXIT_MISS; reason <= KD_EXIT_INVALID_RAY; ++reason)
        map.categories.emplace_back(exit_reason_name(reason));
}

constexpr auto table = std::to_array<MapInfo>({
    {.name = "nodes",
     .title = "interior nodes visited",
     .unit = "visits",
     .kind = count,
     .summary = "How many inner nodes of the tree the ray came through, each as often as it came. The main cost.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return nodes(c); }},
    {.name = "first-visits",
     .title = "interior nodes, first visits",
     .unit = "visits",
     .kind = count,
     .summary = "Inner nodes that the ray met for the first time. Every traversal has to make these visits.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.interior_first); }},
    {.name = "revisits",
     .title = "interior nodes visited again",
     .unit = "visits",
     .kind = count,
     .summary = "Visits to nodes where this ray had been before: the price of having no stack. 0 with a stack.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.interior_again); }},
    {.name = "revisit-share",
     .title = "share of repeated visits",
     .unit = "",
     .kind = ratio,
     .summary = "Repeated visits among all visits to inner nodes: 0 = none is repeated, 0.5 = every second one is.",
     .of_pixel = [](const RayCounters& c,
                    const Hit&) { return nodes(c) > 0 ? float(c.interior_again) / nodes(c) : no_value; }},
    {.name = "leaves",
     .title = "leaves visited",
     .unit = "visits",
     .kind = count,
     .summary = "Leaf cells that the ray passed through, empty ones too. Many of them: space is cut up finely here.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.leaves); }},
    {.name = "triangles",
     .title = "triangles tested",
     .unit = "tests",
     .kind = count,
     .summary = "Triangles that the ray was tested against. One that lies in several leaves counts each time.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.triangle_tests); }},
    {.name = "steps",
     .title = "steps taken",
     .unit = "steps",
     .kind = count,
     .summary = "All that the ray did in the tree: inner nodes, leaves and triangle tests added up.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(lane_steps(c)); }},
    {.name = "restarts",
     .title = "restarts from the root",
     .unit = "restarts",
     .kind = count,
     .summary = "How often kd-restart, push-down or a short stack began again at the top; 1 where ropes gave a ray to "
                "kd-restart.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.restarts); }},
    {.name = "backtracks",
     .title = "backtracks from a leaf",
     .unit = "backtracks",
     .kind = count,
     .summary = "How often kd-backtrack climbed up from a leaf to find the next one. 0 for other traversals.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.backtracks); }},
    {.name = "stack-depth",
     .title = "deepest stack",
     .unit = "entries",
     .kind = count,
     .summary = "Most cells that waited on the stack at one time. 0 for a traversal that has no stack.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.stack_depth); }},
    {.name = "rays",
     .title = "rays traced",
     .unit = "rays",
     .kind = count,
     .summary = "How many rays of this kind the pixel traced: one for each light, bounce and sample that needed one.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.rays); }},
    {.name = "exit",
     .title = "why the ray ended",
     .unit = "",
     .kind = category,
     .summary = "Hit and miss are answers. Any other colour is a ray that was given up.",
     .of_pixel = [](const RayCounters& c, const Hit&) { return float(c.exit_reason); },
     .describe = name_exit_reasons},
    {.name = "t",
     .title = "distance to the hit",
     .unit = "scene units",
     .kind = length,
     .summary = "How far the ray went until it hit something. No value where it hit nothing.",
     .of_pixel =
         [](const RayCounters&, const Hit& hit) {
             if (hit.triangle < 0) return no_value;
             return std::isnan(hit.t) ? std::numeric_limits<float>::infinity() : hit.t;
         }},
});

}  // namespace

std::span<const MapInfo> pixel_maps() { return table; }

}  // namespace kd
