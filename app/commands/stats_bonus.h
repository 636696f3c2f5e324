// stats --bonus: what the bonus for empty space does to trees, and to the time of the same picture.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"

namespace kd {

int run_bonuses(const CommonOptions& options, bool as_json, CommandContext& context);

}  // namespace kd
