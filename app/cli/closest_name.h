// "Did you mean": the known name nearest to a mistyped one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kd {

/// The one of `known` fewest edits (a letter put in, left out or replaced) away from `word`: at most two, and at most
/// half of the word, so that short names do not resemble everything.
[[nodiscard]] std::optional<std::string> closest_name(std::string_view word, const std::vector<std::string>& known);

/// " (did you mean NAME?)", or "" where no name is close.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace kd
