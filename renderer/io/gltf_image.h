// Pictures of a glTF file: PNG and JPEG.
#pragma once

#include <cstdint>
#include <tiny_gltf.h>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"
#include "renderer/io/gltf_context.h"

namespace kd {

/// Image number `index`, decoded. One white pixel, with a note, where it cannot be read, is neither PNG nor JPEG, is
/// larger than the limit or than the `pixels_left`, which are reduced by what it takes.
[[nodiscard]] Image<Rgba8> decode_gltf_image(GltfContext& context, const tinygltf::Model& model, std::size_t index,
                                             std::uint64_t& pixels_left);

/// Mean of the stored values of all pixels, 0..1 per channel.
[[nodiscard]] Vec3 mean_colour(const Image<Rgba8>& image);

}  // namespace kd
