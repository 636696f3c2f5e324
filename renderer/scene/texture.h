// Images on surfaces, and the coarser copies of them that are looked at from afar.
#pragma once

#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

struct Texture {
    std::vector<Image<Rgba8>> levels;  // the whole image; then each half the one before it, rounded down, down to 1 x 1
    int wrap_x = KD_WRAP_REPEAT;       // see shaders/shared/constants.glsl
    int wrap_y = KD_WRAP_REPEAT;

    bool operator==(const Texture&) const = default;
};

/// What the channels of an image are: halving a picture mixes its light, halving normals the numbers themselves.
enum class TexelKind { colour, normal };

/// The image alone, to be seen as it is from any distance.
[[nodiscard]] Texture plain_texture(Image<Rgba8> image);

/// The image and all its mip maps (Williams, "Pyramidal Parametrics", SIGGRAPH 1983): each texel is the mean of the
/// texels before it that it covers, of which a side of odd length shares some between two. Colours are mixed as light,
/// weighed by alpha.
[[nodiscard]] Texture mip_mapped_texture(Image<Rgba8> image, TexelKind kind);

}  // namespace kd
