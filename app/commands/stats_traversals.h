// What `stats --traversals` does.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/commands/stats_divergence.h"

namespace kd {

/// A table per scene and kind of ray: what each traversal visits, beside what was published of it.
int run_traversals(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context);

}  // namespace kd
