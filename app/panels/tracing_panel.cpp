// TRACING: how rays find their way, on which machine, and what this scene does not need.
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/traversal.h"

namespace kd {

namespace {

void draw_traversal(Edit& edit) {
    const auto all = traversals();
    int index = int(edit.session.trace.traversal);
    const auto name = [&](int i) { return std::string(all[std::size_t(i)].name); };
    const auto summary = [&](int i) { return std::string(all[std::size_t(i)].summary); };
    if (widgets::choice("traversal", index, int(all.size()), name, summary,
                        "How a ray walks the tree. Key T: the next."))
        edit.session.trace.traversal = Traversal(index);
}

void draw_tracer(const EngineState& state, Edit& edit) {
    static constexpr const char* names[] = {"CPU", "GPU, 4 passes"};
    static constexpr const char* summaries[] = {"The shared text as C++, on all cores.",
                                                "The same text as GLSL: RTPrim, ShadePrim, RTRefl and ShadeRefl draw "
                                                "one quad each, with the tree in textures."};
    int index = int(edit.session.tracer);
    const std::string why =
        state.gl.known && !state.gl.available() ? "\n\nNo GPU tracing here: " + state.gl.unavailable : "";
    ImGui::BeginDisabled(!why.empty());
    if (widgets::choice(
            "tracer", index, 2, [](int i) { return std::string(names[i]); },
            [](int i) { return std::string(summaries[i]); }, "Which machine makes the picture. Key V." + why))
        edit.session.tracer = TracerKind(index);
    ImGui::EndDisabled();
}

void draw_leaf_lists(TraceConfig& trace) {
    static constexpr const char* names[] = {"references", "copies"};
    static constexpr const char* summaries[] = {
        "Leaves hold triangle numbers: small, one step further to the vertices.",
        "Leaves hold the vertices themselves: large, and what the paper stores."};
    int index = int(trace.leaf_lists);
    if (widgets::choice(
            "leaf lists", index, 2, [](int i) { return std::string(names[i]); },
            [](int i) { return std::string(summaries[i]); }, "Where leaves keep their triangles."))
        trace.leaf_lists = LeafLists(index);
}

}  // namespace

void draw_tracing_panel(const EngineState& state, Edit& edit) {
    TraceConfig& trace = edit.session.trace;
    draw_traversal(edit);
    draw_tracer(state, edit);
    draw_leaf_lists(trace);
    widgets::toggle("shadows", trace.shadows,
                    "One shadow ray per light and hit (pass ShadePrim). Off: every light reaches everything.");
    widgets::slider("bounces", trace.reflection_depth, 0, 8, "%d",
                    "Reflections that a ray follows (passes RTRefl and ShadeRefl); the paper follows one.");
    widgets::value("rules", "robust",
                   "Rounding never loses a hit: intervals at planes are widened by proven bounds, and progress is "
                   "counted, not by epsilon.");
    if (!state.picture || state.picture->traced.left_out.empty()) return;
    widgets::heading("left out, not needed here");
    for (const std::string& line : state.picture->traced.left_out) widgets::note(line);
}

}  // namespace kd
