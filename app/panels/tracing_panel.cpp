// TRACING: how rays find their way, on which machine, and what this scene does not need.
#include <algorithm>
#include <fmt/format.h>

#include "app/choices.h"
#include "app/panels/applies.h"
#include "app/panels/light_rows.h"
#include "app/panels/panel.h"
#include "app/tracer_choices.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/kdtree/ropes.h"
#include "renderer/trace/traversal.h"
#include "renderer/trace/walk_choices.h"
#include "viz/numbers.h"

namespace kd {

namespace {

/// What only some walks have to choose; greyed out where the rest of the settings leaves it without effect.
void draw_walk_choices(const EngineState& state, TraceConfig& trace) {
    const TraversalInfo& walk = info(trace.traversal);
    if (walk.has(walk_short_stack))
        widgets::slider(
            "entries", trace.short_stack, 1, max_short_stack, "%d",
            "Far children that a ray keeps. More spare restarts, and take registers. Option --short-stack.");
    if (walk.has(walk_ropes)) {
        widgets::toggle(
            "optimised ropes", trace.optimised_ropes,
            "On: each rope leads to the smallest cell that its whole face borders on. Off: to the sibling across "
            "the plane, with all the way down from there. Option --plain-ropes.");
        const bool outside = state.world && leaf_at(state.world->tree, state.camera.eye) < 0;
        widgets::toggle(
            "from the eye's leaf", trace.eye_leaf,
            widgets::tip_of("Primary rays begin in the leaf that the camera is in and spare the way down to "
                            "it. Option --eye-leaf.",
                            outside ? "the camera is outside of the tree" : ""));
        return;
    }
    const std::string idle = why_idle(WalkChoice::entry_tile, trace);
    ImGui::BeginDisabled(!idle.empty());
    widgets::slider(
        "entry tiles", trace.entry_tile, 0, 64, trace.entry_tile == 0 ? "off" : "%d px",
        widgets::tip_of("Primary rays begin at the deepest node outside of which their tile of pixels meets "
                        "nothing (Reshetov et al. 2005, MLRTA), not at the root. Option --entry-tile.",
                        idle));
    ImGui::EndDisabled();
}

void draw_traversal(const EngineState& state, Edit& edit) {
    TraceConfig& trace = edit.session.trace;
    const TraversalInfo& walk = info(trace.traversal);
    std::vector<widgets::Option> options = widgets::options_of(traversals());
    for (std::size_t i = 0; i < options.size(); ++i) {
        TraceConfig chosen = trace;
        chosen.traversal = Traversal(i);
        options[i].missing = why_no_walk(edit.session.tracer, chosen);
    }
    int index = int(trace.traversal);
    if (widgets::choice("traversal", index, options,
                        fmt::format("How a ray walks the tree. Key T: the next. Option --traversal.\n\n{}\n\n{}",
                                    walk.paragraph, walk.source)))
        trace.traversal = Traversal(index);
    draw_walk_choices(state, trace);
}

/// Why the GPU cannot be had, as a paragraph for tooltips.
std::string no_gpu(const EngineState& state) {
    return state.gl.known && !state.gl.available() ? "\n\nNo GPU tracing here: " + state.gl.unavailable : "";
}

void draw_packet_size(TraceConfig& trace) {
    const std::string idle = why_idle(WalkChoice::packet, trace);
    std::string size = name_among(choices::packet_sizes(), trace.packet_size);
    ImGui::BeginDisabled(!idle.empty());
    if (widgets::choice("packet", size,
                        {{"4", "A tile of 2 x 2 pixels."}, {"8", "A tile of 4 x 2."}, {"16", "A tile of 4 x 4."}},
                        widgets::tip_of("Rays that walk together while they agree (Wald et al. 2001). More share more "
                                        "fetches, and part sooner. Option --packet.",
                                        idle)))
        trace.packet_size = chosen(choices::packet_sizes(), size, "packet");
    ImGui::EndDisabled();
}

void draw_tracer(const EngineState& state, Edit& edit) {
    const std::string why = state.gl.known && !state.gl.available() ? state.gl.unavailable : "";
    const auto why_missing = [&](TracerKind tracer) {
        return runs_on_cpu(tracer) || why.empty() ? why_no_walk(tracer, edit.session.trace) : why;
    };
    std::vector<widgets::Option> options;
    for (const NamedValue<TracerKind>& tracer : choices::tracers())
        options.push_back({tracer.name, summary_of(tracer.value), {}, why_missing(tracer.value)});
    int index = int(edit.session.tracer);
    if (widgets::choice("tracer", index, options,
                        "What makes the picture. Maps are the same by all of them, times are not. Key V: the other "
                        "machine. Option --tracer." +
                            no_gpu(state)))
        edits::choose_tracer(edit, TracerKind(index));
    if (edit.session.tracer == TracerKind::cpu_packet) draw_packet_size(edit.session.trace);
}

void draw_leaf_lists(Edit& edit) {
    TraceConfig& trace = edit.session.trace;
    const std::string idle = why_idle(TracerChoice::leaf_lists, edit.session.tracer);
    int index = int(trace.leaf_lists);
    ImGui::BeginDisabled(!idle.empty());
    if (widgets::choice("leaf lists", index,
                        {{"references", "Leaves hold triangle numbers: small, one step further to the vertices."},
                         {"copies", "Leaves hold the vertices themselves: large, and what the paper stores."}},
                        widgets::tip_of("Where leaves keep their triangles. Option --leaf-lists.", idle)))
        trace.leaf_lists = LeafLists(index);
    ImGui::EndDisabled();
}

void draw_nodes(TraceConfig& trace) {
    const std::string idle = why_idle(WalkChoice::nodes, trace);
    int index = int(nodes_in_force(trace));
    ImGui::BeginDisabled(!idle.empty());
    if (widgets::choice("nodes", index,
                        {{"16 bytes", "The paper's texel: four floats, with a link to the parent."},
                         {"8 bytes", "Half the memory, and a fetch half as wide: the kind of node in two bits of its "
                                     "link, and no parent. The paper says that this gains 20 %."}},
                        widgets::tip_of("How the tracer keeps the tree's nodes. Picture and counters stay the same in "
                                        "every bit; time and memory need not. Option --nodes.",
                                        idle)))
        trace.nodes = NodeEncoding(index);
    ImGui::EndDisabled();
}

void draw_early_z(Edit& edit) {
    if (runs_on_cpu(edit.session.tracer)) return;
    const std::string idle = why_idle(TracerChoice::early_z, edit.session.tracer);
    int index = int(edit.session.early_z);
    ImGui::BeginDisabled(!idle.empty());
    if (widgets::choice(
            "early z", index,
            {{"working", "RTPrim leaves 1 for a miss, 0.25 for a hit and 0 for a reflective hit; later quads lie "
                         "between, so pixels that they need not shade are culled before their shader runs."},
             {"as published", "The paper's text: 0 for a hit, 1 for a miss, later quads at 0 with LESS OR EQUAL. Every "
                              "pixel passes that test, so nothing is culled; the picture is the same."}},
            widgets::tip_of("How the GPU skips pixels that a pass need not shade: compare the numbers below. Option "
                            "--early-z.",
                            idle)))
        edit.session.early_z = EarlyZ(index);
    ImGui::EndDisabled();
}

void draw_rules(Edit& edit) {
    TraceConfig& trace = edit.session.trace;
    std::vector<widgets::Option> options = widgets::options_of(all_rules());
    for (std::size_t i = 0; i < options.size(); ++i) {
        TraceConfig chosen = trace;
        chosen.rules = Rules(i);
        options[i].missing = why_no_walk(edit.session.tracer, chosen);
    }
    int index = int(trace.rules);
    if (widgets::choice("rules", index, options,
                        widgets::tip_of("How a walk decides between children and goes on. Published rules lose rays "
                                        "that touch split planes, and some walks never end: see the map 'exit'. Option "
                                        "--rules.",
                                        why_idle(WalkChoice::rules, trace))))
        trace.rules = Rules(index);
}

/// How far rays are mirrored and what is in shadow; greyed out where the scene has nothing to mirror or no light.
void draw_bounces(const EngineState& state, TraceConfig& trace) {
    TraceConfig on = trace;
    on.reflection_depth = std::max(1, trace.reflection_depth);
    const std::string no_mirror = why_absent(state, on, Feature::reflections);
    ImGui::BeginDisabled(!no_mirror.empty());
    widgets::slider("bounces", trace.reflection_depth, 0, 8, "%d",
                    widgets::tip_of("Reflections that a ray follows (passes RTRefl and ShadeRefl); the paper follows "
                                    "one. Option --reflection-depth.",
                                    no_mirror));
    ImGui::EndDisabled();
    on = trace;
    on.shadows = true;
    const std::string no_light = why_absent(state, on, Feature::shadows);
    ImGui::BeginDisabled(!no_light.empty());
    widgets::toggle("shadows", trace.shadows,
                    widgets::tip_of("One shadow ray per light and hit (pass ShadePrim). Off: every light reaches "
                                    "everything. Option --no-shadows.",
                                    no_light));
    ImGui::EndDisabled();
}

void draw_least_contribution(const EngineState& state, TraceConfig& trace) {
    TraceConfig on = trace;
    on.reflection_depth = std::max(1, trace.reflection_depth);
    on.least_contribution = 0;
    const std::string no_mirror = why_absent(state, on, Feature::reflections);
    ImGui::BeginDisabled(!no_mirror.empty());
    widgets::slider(
        "least contribution", trace.least_contribution, 0, 1, "%.4f",
        widgets::tip_of(
            "The second way for a path to end: a reflection that would add less than this to every colour (0..1) "
            "is not followed. 0.004 is one step of 8 bits; 0 follows all bounces. Option --min-contribution.",
            no_mirror),
        true);
    ImGui::EndDisabled();
}

/// What the GPU shaded in the frame shown, by each pass that the scene needs.
void draw_shaded(const EngineState& state, const Picture& picture) {
    widgets::heading("pixels shaded by each pass");
    for (std::size_t p = 0; p < pass_count; ++p) {
        if (!why_no_pass(state, picture.traced.config, Pass(p)).empty()) continue;
        const std::int64_t shaded = picture.traced.time.shaded_pixels[p];
        widgets::value(
            pass_names[p].data(), shaded >= 0 ? number_text(double(shaded)) : "did not run",
            "Runs of this pass's shader, counted exactly. Bounces beyond the first add to those of reflections.");
    }
}

/// "2 passes; left out: RTRefl, ShadeRefl, textures", or without passes where the tracer has none, with all that it
/// does without, and why, in the tooltip.
void draw_passes_run(const TracedFrame& traced) {
    const SceneNeeds& needs = traced.needs;
    const bool passes = traced.tracer == TracerKind::gl_fragment || traced.tracer == TracerKind::gl_compute;
    std::string missing;
    const auto name = [&](bool needed, const char* what) {
        if (!needed) missing += (missing.empty() ? "left out: " : ", ") + std::string(what);
    };
    name(needs.reflections, passes ? "RTRefl, ShadeRefl" : "reflections");
    name(needs.textures, "textures");
    name(needs.normals, "normals");
    name(needs.shadows, "shadow rays");
    const bool cpu = runs_on_cpu(traced.tracer);
    std::string why = fmt::format(
        "{}Features that the {} does without for this scene and these settings: {}{}.",
        passes
            ? "The passes RTPrim and ShadePrim always run; RTRefl and ShadeRefl where something reflects, RTIndirect "
              "and ShadeIndirect where indirect light is sampled.\n\n"
            : "",
        cpu ? "CPU" : "GPU", traced.left_out.size(),
        cpu ? "; what only the GPU's programs can leave out is not counted" : "");
    for (const std::string& line : traced.left_out) why += "\n" + line + ".";
    if (missing.empty()) missing = "nothing is left out";
    const int count = 2 + (needs.reflections ? 2 : 0) + (needs.indirect ? 2 : 0);
    widgets::note(passes ? fmt::format("{} passes; {}", count, missing) : missing);
    widgets::hint(why);
}

}  // namespace

void draw_tracing_panel(const EngineState& state, Edit& edit) {
    TraceConfig& trace = edit.session.trace;
    draw_traversal(state, edit);
    draw_tracer(state, edit);
    draw_bounces(state, trace);
    draw_light_rows(state, edit);
    if (state.picture) draw_passes_run(state.picture->traced);
    if (!widgets::fold("passes and rules", ImGui::GetIO().DisplaySize.y >= theme::px(1200))) return;
    draw_least_contribution(state, trace);
    draw_leaf_lists(edit);
    draw_nodes(trace);
    draw_early_z(edit);
    draw_rules(edit);
    if (state.picture && !runs_on_cpu(state.picture->traced.tracer)) draw_shaded(state, *state.picture);
}

}  // namespace kd
