// The scenes of `verify` and `verify --needs`, one after the other.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/report/json_values.h"

namespace kd {

/// What came of a scene.
struct CheckedScene {
    bool passed = false;
    Json json;
    std::function<void(std::ostream&)> print;  // the table
};

using CheckProgress = std::function<void(float, const std::string&)>;
using CheckScene = std::function<CheckedScene(const Session&, const FlatScene&, const CheckProgress&)>;

/// Opens the scenes of `options`, checks each, with progress, and prints its table, or JSON of all; exit_check_failed
/// unless all have passed. InputError, ContextError, Interrupted.
int check_scenes(const CommonOptions& options, bool as_json, CommandContext& context, const CheckScene& check);

}  // namespace kd
