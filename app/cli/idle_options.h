// Options that were given and have nothing to act on: whoever typed one expects something of it.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"

namespace kd {

/// An option with what it needs in this run.
struct OptionUse {
    std::string option;  // "--range"
    bool acts = true;
    std::string otherwise;  // why it does not, and the remedy
};

/// InputError for the first option that was given and contradicts the rest: "--range: no map is drawn; add --map NAME".
void refuse_idle(const CLI::App& app, const std::vector<OptionUse>& uses);

/// A line on standard error for each option that was given and does no harm by doing nothing.
void note_idle(const CLI::App& app, const std::vector<OptionUse>& uses, const CommandContext& context);

/// The same of --eye-leaf where the eye is in no leaf.
void note_idle_eye(const Session& session, const KdTree& tree, Vec3 eye, const CommandContext& context);

/// A line for each of build_notes().
void note_tree(const BuildReport& report, const CommandContext& context);

/// Option --bins, in a command that makes every tree where `all_builders`.
[[nodiscard]] OptionUse bins_use(const Session& session, bool all_builders);

/// Option --seed, in a command that makes rays at random where `random_rays`.
[[nodiscard]] OptionUse seed_use(const std::string& scene, bool random_rays);

/// What the walk of `session` reads of the options of walks and mirrors; `every_walk` where all are run.
[[nodiscard]] std::vector<OptionUse> walk_uses(const Session& session, bool every_walk);

/// Those of the shared options, as note_idle() takes them. `session` is that of one scene; `all_tracers` where a
/// command runs every tracer and traversal unless one is named, `all_builders` every builder, `random_rays` where it
/// makes rays at random, whatever the scene.
[[nodiscard]] std::vector<OptionUse> shared_uses(const CommonOptions& options, const Session& session, bool all_tracers,
                                                 bool random_rays = false, bool all_builders = false);

}  // namespace kd
