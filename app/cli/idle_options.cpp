#include "app/cli/idle_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <ostream>

#include "app/tracer_choices.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"
#include "renderer/kdtree/ropes.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/walk_choices.h"

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

/// Packets take a tracer and a walk.
OptionUse packet_use(const Session& session, bool one_tracer, bool every_walk) {
    std::string why = one_tracer ? why_idle(TracerChoice::packet, session.tracer) : "";
    if (why.empty() && !every_walk) why = why_idle(WalkChoice::packet, session.trace);
    return {"--packet", why.empty(), why};
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

void note_idle_eye(const Session& session, const KdTree& tree, Vec3 eye, const CommandContext& context) {
    if (session.trace.eye_leaf && leaf_at(tree, eye) < 0)
        context.err << "kdscope: note: --eye-leaf has no effect: the camera is outside of the tree\n";
}

void note_tree(const BuildReport& report, const CommandContext& context) {
    for (const std::string& note : build_notes(report)) context.err << fmt::format("kdscope: note: tree: {}\n", note);
}

OptionUse bins_use(const Session& session, bool all_builders) {
    const Builder* builder = find_builder(session.build.builder);
    return {"--bins", all_builders || (builder && builder->has_bins),
            fmt::format("builder {} has none; --builder binned would use them", session.build.builder)};
}

OptionUse seed_use(const std::string& scene, bool random_rays) {
    return {"--seed", random_rays || is_seeded(scene), fmt::format("nothing in {} is random", scene)};
}

std::vector<OptionUse> walk_uses(const Session& session, bool every_walk) {
    // Where every traversal is run, some have a use for each choice.
    const auto use = [&](const char* option, WalkChoice choice) {
        const std::string why = every_walk ? "" : why_idle(choice, session.trace);
        return OptionUse{option, why.empty(), why};
    };
    const bool walks = every_walk || session.trace.traversal != Traversal::naive;
    return {
        use("--nodes", WalkChoice::nodes),
        {"--leaf-lists", walks, "the loop over all triangles (naive) walks no tree"},
        use("--short-stack", WalkChoice::short_stack),
        use("--plain-ropes", WalkChoice::plain_ropes),
        use("--entry-tile", WalkChoice::entry_tile),
        use("--eye-leaf", WalkChoice::eye_leaf),
        use("--rules", WalkChoice::rules),
        {"--min-contribution", session.trace.reflection_depth > 0, "--reflection-depth 0 follows no mirror ray"},
    };
}

std::vector<OptionUse> shared_uses(const CommonOptions& options, const Session& session, bool all_tracers,
                                   bool random_rays, bool all_builders) {
    const bool named = options.tracer.has_value() || !all_tracers;
    const bool every_walk = all_tracers && !options.traversal;
    // Where every tracer is run, some have a use for each choice.
    const auto use = [&](const char* option, TracerChoice choice) {
        const std::string why = named ? why_idle(choice, session.tracer) : "";
        return OptionUse{option, why.empty(), why};
    };
    std::vector<OptionUse> uses{
        use("--context", TracerChoice::context),
        use("--early-z", TracerChoice::early_z),
        use("--count-shaded", TracerChoice::count_shaded),
        use("--threads", TracerChoice::threads),
        packet_use(session, named, every_walk),
        use("--leaf-lists", TracerChoice::leaf_lists),
        bins_use(session, all_builders && !options.builder),
        seed_use(session.scene, random_rays),
    };
    std::ranges::move(walk_uses(session, every_walk), std::back_inserter(uses));
    return uses;
}

}  // namespace kd
