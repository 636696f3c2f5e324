// Which program each step of a frame needs.
#pragma once

#include "renderer/gl/compute_settings.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/program.h"
#include "renderer/scene/needs.h"

namespace kd {

/// The steps that draw: the passes, `mark` between bounces (of fragment shaders alone), and `rays`
/// outside of frames. `traverse` and `intersect` are the kernels of GlMode::wavefront, which walk the rays of all
/// others; `list_hits` and `list_reflections` tell GlMode::compute which pixels have work.
enum class Step {
    rt_prim,
    shade_prim,
    rt_refl,
    shade_refl,
    rt_indirect,
    shade_indirect,
    mark,
    rays,
    traverse,
    intersect,
    list_hits,
    list_reflections
};

/// What decides a program beside its step.
struct ProgramSettings {
    GlMode mode = GlMode::fragment;
    ComputeSettings compute;  // where the mode is not fragment
    TraceConfig trace;
    SceneNeeds needs;
    EarlyZ early_z = EarlyZ::working;
    bool count_shaded = false;
    bool listed = false;         // GlMode::compute: works at a list of pixels
    int phase = 0;               // GlMode::wavefront: 1 asks for the rays, 2 reads their answers; 0: neither
    bool later_bounce = false;   // rt_refl and shade_refl after the first bounce
    bool limited_loops = false;  // the driver ends loops by itself (software renderers)
    bool fused = false, corrected_rounding = false;  // see shaders/shared/rounding.glsl
};

/// Whether a step traces rays.
[[nodiscard]] bool step_walks(Step step, const SceneNeeds& needs);

[[nodiscard]] ProgramKey program_key(Step step, const ProgramSettings& settings);

/// The kernel that turns a queue's rays into a dispatch.
[[nodiscard]] ProgramKey plan_key(int queue, const ProgramSettings& settings);

/// KD_STEPS of a walk that is written step by step (shaders/steps), "" where none is.
[[nodiscard]] const char* steps_of(Traversal traversal);

/// How a step tests and writes depth. The quads lie between the depths that RTPrim writes.
struct DepthRule {
    GLenum function;
    bool write;
    const char* quad;  // depth of the quad, as shader text
};
[[nodiscard]] DepthRule depth_rule(Step step, EarlyZ early_z);

}  // namespace kd
