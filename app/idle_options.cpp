#include "app/idle_options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"
#include "renderer/scene/procedural.h"

namespace kd {

namespace {

std::vector<const OptionUse*> idle(const CLI::App& app, const std::vector<OptionUse>& uses) {
    std::vector<const OptionUse*> found;
    for (const OptionUse& use : uses) {
        const CLI::Option* option = app.get_option_no_throw(use.option);
        if (option && option->count() > 0 && !use.acts) found.push_back(&use);
    }
    return found;
}

bool is_seeded(const std::string& scene) {
    const ProceduralScene* procedural = find_procedural(scene);
    return procedural && procedural->seeded;
}

}  // namespace

void refuse_idle(const CLI::App& app, const std::vector<OptionUse>& uses) {
    for (const OptionUse* use : idle(app, uses)) throw InputError(fmt::format("{}: {}", use->option, use->otherwise));
}

void note_idle(const CLI::App& app, const std::vector<OptionUse>& uses, const CommandContext& context) {
    for (const OptionUse* use : idle(app, uses))
        context.err << fmt::format("kdscope: note: {} has no effect: {}\n", use->option, printable(use->otherwise));
}

OptionUse bins_use(const Session& session, bool all_builders) {
    const Builder* builder = find_builder(session.build.builder);
    return {"--bins", all_builders || (builder && builder->has_bins),
            fmt::format("builder {} has none; --builder binned would use them", session.build.builder)};
}

std::vector<OptionUse> shared_uses(const CommonOptions& options, const Session& session, bool all_tracers,
                                   bool random_rays, bool all_builders) {
    const bool named = options.tracer.has_value() || !all_tracers;
    const bool gl = !named || session.tracer == TracerKind::gl_fragment;
    const bool cpu = !named || session.tracer == TracerKind::cpu;
    const bool walks = (all_tracers && !options.traversal) || session.trace.traversal != Traversal::naive;
    const auto walked = [&](WalkNeeds need) {
        return (all_tracers && !options.traversal) || info(session.trace.traversal).has(need);
    };
    const std::string no_gl = "only the CPU traces; --tracer gl-fragment would use it";
    const std::string no_walk = "the loop over all triangles (naive) walks no tree";
    return {
        {"--context", gl, no_gl},
        {"--early-z", gl, no_gl},
        {"--count-shaded", gl, no_gl},
        {"--threads", cpu, "gl-fragment traces, the CPU does not; --tracer cpu would use it"},
        {"--leaf-lists", walks, no_walk},
        {"--short-stack", walked(walk_short_stack), "the walk keeps none; --traversal short-stack would"},
        {"--plain-ropes", walked(walk_ropes), "the walk follows none; --traversal ropes would"},
        {"--entry-tile", session.trace.entry_tile == 0 || all_tracers || enters_by_tile(session.trace),
         "only robust walks down from a node use it; ropes and naive are none"},
        {"--eye-leaf", walked(walk_ropes), "only ropes lead on from there; add --traversal ropes"},
        {"--rules", walks, no_walk},
        {"--min-contribution", session.trace.reflection_depth > 0, "--reflection-depth 0 follows no mirror ray"},
        bins_use(session, all_builders && !options.builder),
        {"--seed", random_rays || is_seeded(session.scene), fmt::format("nothing in {} is random", session.scene)},
    };
}

}  // namespace kd
