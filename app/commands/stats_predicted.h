// What `stats --predicted` does.
#pragma once

#include "app/commands/stats_divergence.h"

namespace kd {

/// Visits per node against the surface area heuristic's prediction, for uniform lines and each kind of the picture's
/// rays: a table per scene, for one builder or all.
int run_predicted(const CommonOptions& common, const DivergenceOptions& options, bool every_builder, bool json,
                  CommandContext& context);

}  // namespace kd
