// From the bytes of a glTF file to tinygltf's model, with all that it refers to.
#pragma once

#include <filesystem>
#include <string_view>
#include <tiny_gltf.h>

#include "renderer/io/gltf_context.h"

namespace kd {

/// The folder of `path` is the only place where files are opened, and its ending tells what is expected. Images stay
/// encoded: Image::image holds the bytes of the PNG or JPEG, and is empty where they could not be read (noted).
/// InputError for all else that is wrong with the file's structure; afterwards buffers are as long as they say and
/// bufferViews lie within them. Accessors are not yet checked.
[[nodiscard]] tinygltf::Model parse_gltf(GltfContext& context, std::string_view bytes,
                                         const std::filesystem::path& path);

}  // namespace kd
