// Scene files that were opened, newest first: the list of scenes offers them again.
#pragma once

#include <string>
#include <vector>

#include "app/window/widgets.h"

namespace kd {

/// Puts the file that `scene` names to the front, as an absolute path, and drops the oldest beyond a handful. Nothing
/// where `scene` is no file: procedural scenes and those that come with the program are in the list anyway.
void add_recent(std::vector<std::string>& recent, const std::string& scene);

/// Those files for a list of scenes: the name of the file, with that of its folder where two are called alike, and the
/// whole path as the summary. The one that `scene` names goes by that name.
[[nodiscard]] std::vector<widgets::Option> recent_options(const std::vector<std::string>& recent,
                                                          const std::string& scene);

}  // namespace kd
