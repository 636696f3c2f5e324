#include "renderer/gl/pass_programs.h"

#include <array>

namespace kd {

namespace {

constexpr std::array<const char*, 6> entry_points{"rt_prim", "shade_prim", "rt_refl", "shade_refl", "mark", "rays"};

std::string_view walk_function(const TraceConfig& trace) {
    const TraversalInfo& walk = info(trace.traversal);
    return trace.rules == Rules::robust ? walk.function : walk.published_function;
}

const char* flag(bool on) { return on ? "1" : "0"; }

}  // namespace

DepthRule depth_rule(Step step, EarlyZ early_z) {
    // The marking quad lies at the depth of a hit whose path has ended, and replaces only the 0 of a path that goes on.
    if (step == Step::mark) return {GL_GREATER, true, "0.25"};
    if (step == Step::rt_prim || step == Step::rays) return {GL_ALWAYS, true, "0.0"};
    if (early_z == EarlyZ::as_published) return {GL_LEQUAL, false, "0.0"};
    return {GL_GREATER, false, step == Step::shade_prim ? "0.5" : "0.125"};
}

ProgramKey program_key(Step step, const ProgramSettings& s) {
    const bool shades = step == Step::shade_prim || step == Step::shade_refl;
    const bool reflects = step == Step::rt_refl;
    const bool traces = step != Step::mark;
    ProgramKey key;
    key.vertex = "fragment/quad.vert";
    key.fragment = std::string("fragment/") + entry_points[static_cast<std::size_t>(step)] + ".frag";
    // What a step does not read stays at one value, so that it shares programs across settings.
    key.defines = {
        {"KD_COUNTERS", flag(s.trace.counters && traces)},
        {"KD_DUPLICATED", flag(s.trace.leaf_lists == LeafLists::duplicated && traces)},
        {"KD_NORMALS", flag(s.needs.normals && (shades || reflects))},
        {"KD_TEXTURES", flag(s.needs.textures && shades)},
        {"KD_SHADOWS", flag(s.needs.shadows && shades)},
        {"KD_TRAVERSE", std::string(traces ? walk_function(s.trace) : "traverse_naive")},
        {"KD_RULES", traces ? std::to_string(int(s.trace.rules)) : "0"},
        {"KD_STACK_SIZE", info(s.trace.traversal).needs_stack && traces ? std::to_string(s.stack_size) : "1"},
        {"KD_LATER_BOUNCE", flag(s.later_bounce)},
        {"KD_QUAD_DEPTH", depth_rule(step, s.early_z).quad},
        {"KD_PUBLISHED_DEPTH", flag(s.early_z == EarlyZ::as_published && step == Step::rt_prim)},
        {"KD_COUNT_SHADED", flag(s.count_shaded && step != Step::mark && step != Step::rays)},
        {"KD_CORRECTED_ROUNDING", flag(s.corrected_rounding && step != Step::mark)},
        {"KD_LOOP_LIMIT", flag(s.limited_loops && traces)},
    };
    return key;
}

}  // namespace kd
