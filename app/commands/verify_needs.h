// verify --needs: nobody misses what is left out.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"

namespace kd {

/// Every scene of `options` with each feature put back, on every machine asked for; the table, or JSON. InputError,
/// ContextError, Interrupted.
int verify_needs(const CommonOptions& options, bool as_json, CommandContext& context);

}  // namespace kd
