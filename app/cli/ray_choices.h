// Kinds of rays as the command line names them.
#pragma once

#include <algorithm>

#include "app/cli/typed_options.h"
#include "renderer/trace/frame.h"

namespace kd {

/// Of a pass's rays, as --rays takes it: "reflection-shadow".
[[nodiscard]] inline std::string option_name(Pass pass) {
    std::string name(ray_names[std::size_t(pass)]);
    std::ranges::replace(name, ' ', '-');
    return name;
}

[[nodiscard]] inline std::vector<NamedValue<Pass>> ray_choices() {
    std::vector<NamedValue<Pass>> rays;
    for (int pass = 0; pass < pass_count; ++pass) rays.push_back({option_name(Pass(pass)), Pass(pass)});
    return rays;
}

}  // namespace kd
