// Maps of how each pixel's hit compares with the exact one, which double precision finds without a tree.
#include <array>
#include <cmath>
#include <limits>

#include "renderer/trace/upper_bound.h"
#include "viz/map.h"
#include "viz/numbers.h"

namespace kd {
namespace {

using enum MapInfo::Kind;

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// An error beyond any float is as good as infinite.
float t_error(const JudgedHit& judged) {
    const bool both_missed = judged.exact.triangle < 0 && !is_wrong(judged.verdict) && !std::isinf(judged.ulps);
    return both_missed ? no_value : float(judged.ulps);
}

void add_facts(const JudgedLayer& judged, ScalarMap& map) {
    const double n = double(judged.compared());
    const std::int64_t wrong = judged.wrong();
    map.facts.push_back({"compared", number_text(n)});
    map.facts.push_back({"wrong", number_text(double(wrong))});
    if (wrong == 0 && n > 0)
        map.facts.push_back({"0 of n means", "< " + number_text(upper_bound_95(0, judged.compared()))});
}

void name_verdicts(const JudgedLayer& judged, ScalarMap& map) {
    map.categories.assign(verdict_names.begin(), verdict_names.end());
    add_facts(judged, map);
}

constexpr auto table = std::to_array<MapInfo>({
    {.name = "oracle",
     .title = "hits against double precision",
     .unit = "",
     .kind = category,
     .summary = "Whether the ray found what a loop over all triangles in double precision finds, and how it failed.",
     .of_judged = [](const JudgedHit& judged) { return float(judged.verdict); },
     .describe_judged = name_verdicts},
    {.name = "t-error",
     .title = "error of the distance to the hit",
     .unit = "ulp",
     .kind = length,
     .summary = "Distance found minus exact distance, in units in the last place. Not finite where one of them missed.",
     .of_judged = t_error,
     .describe_judged = add_facts},
});

}  // namespace

std::span<const MapInfo> oracle_maps() { return table; }

}  // namespace kd
