#include "app/panels/light_rows.h"

#include <cmath>
#include <fmt/format.h>

#include "app/panels/applies.h"
#include "app/window/widgets.h"

namespace kd {

namespace {

constexpr int most_samples = 4096;

/// A switch of one effect; greyed out where the scene has nothing of it.
void draw_effect(const EngineState& state, TraceConfig& trace, Feature feature, const char* label,
                 bool Sampling::*effect, const char* tooltip) {
    TraceConfig sampled = trace;
    sampled.sampling.sample = 0;
    sampled.sampling.*effect = true;
    const std::string absent = why_absent(state, sampled, feature);
    ImGui::BeginDisabled(!absent.empty());
    widgets::toggle(label, trace.sampling.*effect, widgets::tip_of(tooltip, absent));
    ImGui::EndDisabled();
}

/// "37 of 256 samples, error 0.012, 12 of 64 tiles done".
std::string count_text(const SampleCount& count, int most) {
    std::string text = fmt::format("{} of {} samples", count.samples, most);
    if (std::isfinite(count.error)) text += fmt::format(", error {:.2g}", count.error);
    if (count.converged_tiles > 0) text += fmt::format(", {} of {} tiles done", count.converged_tiles, count.tiles);
    return text;
}

}  // namespace

void draw_light_rows(const EngineState& state, Edit& edit) {
    Session& session = edit.session;
    widgets::slider("samples of light", session.samples, 0, most_samples, session.samples == 0 ? "off" : "%d",
                    "Off: one ray towards the middle of each light, as in the paper. On: every sample draws a point of "
                    "each light, a facet of each rough mirror and a direction of indirect light for every pixel, and "
                    "the picture is their mean; it grows while nothing changes. Option --samples.");
    if (session.samples == 0) return;
    widgets::slider(
        "stop at error", session.sample_error, 0, 0.1f, session.sample_error == 0 ? "never" : "%.3f",
        "A tile of 32 x 32 pixels gets no more samples once the standard error of its mean colour, of white "
        "1, is at most this: see the map 'rays'. Option --sample-error.");
    draw_effect(state, session.trace, Feature::soft_shadows, "soft shadows", &Sampling::soft_shadows,
                "Lights have their radius. Off: they are points. Option --no-soft-shadows.");
    draw_effect(state, session.trace, Feature::gloss, "gloss", &Sampling::gloss,
                "Rough mirrors reflect by facets. Off: they are mirrors. Option --no-gloss.");
    draw_effect(state, session.trace, Feature::indirect, "indirect light", &Sampling::indirect,
                "Light that comes by way of another surface (RTIndirect, ShadeIndirect) in place of the light that is "
                "everywhere. Off: that. Option --no-indirect.");
    if (state.picture && state.picture->traced.samples)
        widgets::note(count_text(*state.picture->traced.samples, session.samples));
}

}  // namespace kd
