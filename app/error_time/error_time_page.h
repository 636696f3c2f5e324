// The page that explains the reports: two sentences each, the diagrams, the numbers that matter, and what was left out.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"

namespace kd {

/// Writes index.html, the diagrams and all tables into `folder`, each file whole or not at all and the page last.
/// Returns their names. InputError, Interrupted.
std::vector<std::string> write_error_time(const std::filesystem::path& folder, const ErrorTimeResults& results,
                                          const std::stop_token& stop);

}  // namespace kd
