// Coarser copies of images.

#include "renderer/scene/texture.h"

#include <gtest/gtest.h>

namespace kd {
namespace {

Image<Rgba8> image_of(int width, std::vector<Rgba8> pixels) {
    Image<Rgba8> image(width, int(pixels.size()) / width);
    image.pixels = std::move(pixels);
    return image;
}

TEST(MipMaps, HalveDownToOneTexel) {
    const Texture texture = mip_mapped_texture(Image<Rgba8>(13, 3), TexelKind::colour);
    std::vector<std::array<int, 2>> sizes;
    for (const Image<Rgba8>& level : texture.levels) sizes.push_back({level.width, level.height});
    EXPECT_EQ(sizes, (std::vector<std::array<int, 2>>{{13, 3}, {6, 1}, {3, 1}, {1, 1}}));
    EXPECT_EQ(mip_mapped_texture(Image<Rgba8>(1, 1), TexelKind::normal).levels.size(), 1u);
    EXPECT_EQ(plain_texture(Image<Rgba8>(13, 3)).levels.size(), 1u);
}

TEST(MipMaps, ColoursAreMixedAsLight) {
    const Image<Rgba8> image = image_of(2, {{0, 0, 0, 255}, {255, 100, 0, 255}});
    // Half the light of 1 is 0.735 in sRGB: 188 of 255; half that of 100 of 255 is 71.
    EXPECT_EQ(mip_mapped_texture(image, TexelKind::colour).levels.at(1).at(0, 0), (Rgba8{188, 71, 0, 255}));
    EXPECT_EQ(mip_mapped_texture(image, TexelKind::normal).levels.at(1).at(0, 0), (Rgba8{128, 50, 0, 255}));
}

TEST(MipMaps, ATransparentTexelHasNoColourToMix) {
    const Image<Rgba8> image = image_of(2, {{255, 0, 0, 0}, {10, 20, 30, 200}});
    EXPECT_EQ(mip_mapped_texture(image, TexelKind::colour).levels.at(1).at(0, 0), (Rgba8{10, 20, 30, 100}));
}

TEST(MipMaps, ASideOfOddLengthSharesItsTexels) {
    // Five texels become two of two and a half each.
    const auto grey = [](unsigned char value) { return Rgba8{value, value, value, 255}; };
    const Image<Rgba8> image = image_of(5, {grey(0), grey(50), grey(100), grey(150), grey(200)});
    const Image<Rgba8> half = mip_mapped_texture(image, TexelKind::normal).levels.at(1);
    EXPECT_EQ(half.pixels, (std::vector<Rgba8>{grey(40), grey(160)}));  // (0 + 50 + 50) / 2.5, (50 + 150 + 200) / 2.5
}

}  // namespace
}  // namespace kd
