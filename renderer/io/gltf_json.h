// The JSON of a glTF file: parsing, and all checks that need nothing but it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "renderer/io/gltf_context.h"

namespace kd {

/// InputError for text that is not a JSON object, is nested more than 256 deep (later code may recurse), or holds more
/// values than the limit.
[[nodiscard]] nlohmann::json parse_gltf_json(const GltfContext& context, std::string_view text);

/// Version, required extensions, and the type and range of every value that the loader relies on: indices name
/// something that exists, sizes and offsets are whole numbers, lists have their length. InputError with the value's
/// JSON pointer.
void check_gltf_json(GltfContext& context, const nlohmann::json& json);

}  // namespace kd
