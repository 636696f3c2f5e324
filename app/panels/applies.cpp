#include "app/panels/applies.h"

#include <fmt/format.h>

namespace kd {

std::string why_absent(const EngineState& state, const TraceConfig& trace, Feature feature) {
    return state.world ? why_left_out(feature, state.world->facts, trace) : "";
}

std::string why_no_pass(const EngineState& state, const TraceConfig& trace, Pass pass) {
    if (of_reflections(pass)) return why_absent(state, trace, Feature::reflections);
    return of_indirect_light(pass) ? why_absent(state, trace, Feature::indirect) : "";
}

std::string why_absent(const EngineState& state, const TraceConfig& trace, Pass rays) {
    std::string why = why_no_pass(state, trace, rays);
    if (why.empty() && shades(rays)) why = why_absent(state, trace, Feature::shadows);
    return why;
}

std::vector<widgets::Option> ray_options(const EngineState& state, const TraceConfig& trace) {
    std::vector<widgets::Option> options;
    for (std::size_t p = 0; p < pass_count; ++p) {
        options.push_back({std::string(ray_names[p]), fmt::format("Traced by pass {}.", pass_names[p])});
        options.back().missing = why_absent(state, trace, Pass(p));
    }
    return options;
}

}  // namespace kd
