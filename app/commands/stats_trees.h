// What `stats` does where no other table is asked for.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"

namespace kd {

/// The session's builder alone, or all there are.
[[nodiscard]] std::vector<std::string> builders_of(const Session& session, bool every);

/// Facts about each scene's tree, what its build took, and what the picture's rays visit: one column per builder.
int run_trees(const CommonOptions& options, bool every_builder, bool as_json, CommandContext& context);

}  // namespace kd
