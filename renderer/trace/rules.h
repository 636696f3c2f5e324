// How a walk decides which children to visit and where to go on: robustly, or as it was printed.
#pragma once

#include <span>
#include <string_view>

namespace kd {

/// The numbers are those of KD_RULES_... in shaders/shared/constants.glsl.
enum class Rules { robust, as_published, first_edition };

struct RulesInfo {
    Rules id;
    std::string_view name;  // on the command line
    std::string_view summary;
};

[[nodiscard]] std::span<const RulesInfo> all_rules();
[[nodiscard]] const RulesInfo& info(Rules rules);

}  // namespace kd
