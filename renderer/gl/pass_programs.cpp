#include "renderer/gl/pass_programs.h"

#include <array>

#include "renderer/gl/ray_queues.h"
#include "renderer/scene/needs_sizes.h"

namespace kd {

namespace {

// The passes of indirect light are those of reflections with KD_SCATTER.
constexpr std::array<const char*, 12> entry_points{"rt_prim",  "shade_prim", "rt_refl",   "shade_refl",
                                                   "rt_refl",  "shade_refl", "mark",      "rays",
                                                   "traverse", "intersect",  "list_hits", "list_reflections"};

std::string_view walk_function(const TraceConfig& trace) {
    const TraversalInfo& walk = info(trace.traversal);
    return trace.rules == Rules::robust ? walk.function : walk.published_function;
}

bool is_kernel(Step step) { return step == Step::traverse || step == Step::intersect; }
bool is_list(Step step) { return step == Step::list_hits || step == Step::list_reflections; }
bool is_pass(Step step) { return step <= Step::shade_indirect; }
bool is_shading(Step step) { return is_pass(step) && shades(static_cast<Pass>(step)); }
bool is_scattering(Step step) { return is_pass(step) && of_indirect_light(static_cast<Pass>(step)); }

void name_files(ProgramKey& key, Step step, GlMode mode) {
    const std::string name = entry_points[static_cast<std::size_t>(step)];
    if (mode == GlMode::fragment) {
        key.vertex = "fragment/quad.vert";
        key.fragment = "fragment/" + name + ".frag";
    } else {
        key.compute = (is_kernel(step) ? "wavefront/" : "compute/") + name + ".comp";
    }
}

const char* flag(bool on) { return on ? "1" : "0"; }

}  // namespace

DepthRule depth_rule(Step step, EarlyZ early_z) {
    // The marking quad lies at the depth of a hit whose path has ended, and replaces only the 0 of a path that goes on.
    if (step == Step::mark) return {GL_GREATER, true, "0.25"};
    if (step == Step::rt_prim || step == Step::rays) return {GL_ALWAYS, true, "0.0"};
    if (early_z == EarlyZ::as_published) return {GL_LEQUAL, false, "0.0"};
    return {GL_GREATER, false, step == Step::shade_prim || is_scattering(step) ? "0.5" : "0.125"};
}

namespace {

/// The kernels read from a ray's state where it begins.
const char* entry_setting(Step step, const TraceConfig& trace) {
    if (enters_by_tile(trace) && step == Step::rt_prim) return "2";
    const bool enters = enters_by_tile(trace) || enters_by_eye(trace);
    return enters && (step == Step::rt_prim || step == Step::traverse) ? "1" : "0";
}

/// What only one kind of shaders reads.
ShaderDefines defines_of_mode(Step step, const ProgramSettings& s, bool walks) {
    if (s.mode == GlMode::fragment)
        return {{"KD_QUAD_DEPTH", depth_rule(step, s.early_z).quad},
                {"KD_PUBLISHED_DEPTH", flag(s.early_z == EarlyZ::as_published && step == Step::rt_prim)}};
    ShaderDefines defines{{"KD_WIDE_REFERENCES", flag(s.needs.wide_references && walks)},
                          {"KD_GROUP_X", std::to_string(s.compute.x)},
                          {"KD_GROUP_Y", std::to_string(s.compute.y)},
                          {"KD_MORTON", flag(s.compute.morton)},
                          {"KD_LISTED", flag(s.listed)},
                          {"KD_DEALT", flag(s.compute.dealt.value_or(false))},
                          {"KD_STORAGE", flag(s.compute.storage)}};
    if (s.mode == GlMode::wavefront) {
        defines["KD_PHASE"] = std::to_string(walks ? s.phase : 0);
        defines["KD_FOUND_WORD"] = std::to_string(RayWords::found);
        defines["KD_WALK_WORD"] = std::to_string(RayWords::walk);
        defines["KD_STACK_WORD"] = std::to_string(RayWords::stack);
        if (is_kernel(step)) defines["KD_STEPS"] = steps_of(s.trace.traversal);
    }
    return defines;
}

}  // namespace

bool step_walks(Step step, const SceneNeeds& needs) {
    return step != Step::mark && !is_list(step) && (!is_shading(step) || needs.shadows);
}

ProgramKey plan_key(int queue, const ProgramSettings& s) {
    ProgramKey key;
    key.compute = "wavefront/plan.comp";
    key.defines = {{"KD_QUEUE", std::to_string(queue)},
                   {"KD_GROUP_X", std::to_string(s.compute.x)},
                   {"KD_GROUP_Y", std::to_string(s.compute.y)}};
    return key;
}

const char* steps_of(Traversal traversal) {
    switch (traversal) {
        case Traversal::stack: return "0";
        case Traversal::restart: return "1";
        case Traversal::backtrack: return "2";
        case Traversal::push_down: return "3";
        case Traversal::short_stack: return "4";
        case Traversal::ropes: return "5";
        default: return "";
    }
}

ProgramKey program_key(Step step, const ProgramSettings& s) {
    const bool shades = is_shading(step);
    const bool scatters = step == Step::rt_indirect;
    const bool leaves_surface = step == Step::rt_refl || scatters;
    const bool walks = step_walks(step, s.needs);
    const bool masks = s.needs.masks && walks;
    const bool bends = s.needs.normal_maps && (shades || leaves_surface);
    const bool tints = s.needs.textures && (shades || scatters);
    const bool looks_up_materials = masks || (step != Step::rays && step != Step::list_hits && !is_kernel(step) &&
                                              (step != Step::rt_prim || s.needs.reflections));
    const bool calculates = step != Step::mark && !is_list(step);
    ProgramKey key;
    name_files(key, step, s.mode);
    // What a step does not read stays at one value, so that it shares programs across settings.
    key.defines = {
        {"KD_COUNTERS", flag(s.needs.counters && walks)},
        {"KD_PACKED_NODES", flag(!s.needs.wide_nodes && walks && s.trace.traversal != Traversal::naive)},
        {"KD_DUPLICATED", flag(s.needs.leaf_copies && walks)},
        {"KD_NORMALS", flag(s.needs.normals && (shades || leaves_surface))},
        {"KD_TEXTURES", flag(tints)},
        {"KD_MIP_MAPS", flag(s.needs.mip_maps && (tints || bends))},
        {"KD_WRAPS", flag(s.needs.wraps && (tints || bends || masks))},
        {"KD_NORMAL_MAPS", flag(bends)},
        {"KD_MASKS", flag(masks)},
        {"KD_SHADOWS", flag(s.needs.shadows && shades)},
        {"KD_REFLECTIONS", flag(s.needs.reflections && step == Step::rt_prim)},
        {"KD_HIGHLIGHTS", flag(s.needs.highlights && shades)},
        {"KD_EMISSION", flag(s.needs.emission && shades)},
        {"KD_SOFT_SHADOWS", flag(s.needs.soft_shadows && shades)},
        {"KD_GLOSS", flag(s.needs.gloss && step == Step::rt_refl)},
        {"KD_INDIRECT", flag(s.needs.indirect && step == Step::shade_prim)},
        {"KD_SCATTER", flag(is_scattering(step))},
        {"KD_DIRECTIONAL_LIGHTS", flag(s.needs.directional_lights && shades)},
        {"KD_PLACED_LIGHTS", flag(s.needs.placed_lights && shades)},
        {"KD_SPOT_LIGHTS", flag(s.needs.spot_lights && shades)},
        {"KD_LIGHTS", shades ? std::to_string(s.needs.many_lights ? -1 : s.needs.lights) : "0"},
        {"KD_MATERIAL_NUMBERS", flag(s.needs.material_numbers && looks_up_materials)},
        {"KD_TRAVERSE", std::string(walks ? walk_function(s.trace) : "traverse_naive")},
        {"KD_RULES", walks ? std::to_string(int(s.trace.rules)) : "0"},
        {"KD_STACK_SIZE", info(s.trace.traversal).has(walk_stack) && walks ? std::to_string(s.needs.levels) : "1"},
        {"KD_LONG_TRAIL", flag(walks && info(s.trace.traversal).has(walk_trail) && s.needs.levels > short_trail)},
        {"KD_ENTRY", entry_setting(step, s.trace)},
        {"KD_SHORT_STACK",
         walks && info(s.trace.traversal).has(walk_short_stack) ? std::to_string(s.trace.short_stack) : "1"},
        {"KD_LATER_BOUNCE", flag(s.later_bounce)},
        {"KD_COUNT_SHADED", flag(s.count_shaded && is_pass(step))},
        {"KD_CORRECTED_ROUNDING", flag(s.corrected_rounding && calculates)},
        {"KD_FUSED", flag(s.fused && calculates)},
        {"KD_LOOP_LIMIT", flag(s.limited_loops && walks)},
    };
    key.defines.merge(defines_of_mode(step, s, walks));
    return key;
}

}  // namespace kd
