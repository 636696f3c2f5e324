#include "app/panels/applies.h"

#include <fmt/format.h>

namespace kd {

std::string why_absent(const EngineState& state, const TraceConfig& trace, Feature feature) {
    return state.world ? why_left_out(feature, state.world->facts, trace) : "";
}

std::string why_no_pass(const EngineState& state, const TraceConfig& trace, Pass pass) {
    const bool mirrored = pass == Pass::rt_refl || pass == Pass::shade_refl;
    return mirrored ? why_absent(state, trace, Feature::reflections) : "";
}

std::string why_absent(const EngineState& state, const TraceConfig& trace, Pass rays) {
    const bool shadow = rays == Pass::shade_prim || rays == Pass::shade_refl;
    std::string why = why_no_pass(state, trace, rays);
    if (why.empty() && shadow) why = why_absent(state, trace, Feature::shadows);
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
