// A table of what glTF 2.0 demands of single values, checked in one way.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "renderer/io/gltf_context.h"

namespace kd {

/// header: asset and extensions. content: all else.
enum class GltfRules { header, content };

/// InputError with the JSON pointer of the first value that breaks a rule.
void check_gltf_rules(const GltfContext& context, const nlohmann::json& gltf, GltfRules rules);

}  // namespace kd
