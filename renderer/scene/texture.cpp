#include "renderer/scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "renderer/geometry/srgb.h"

namespace kd {

namespace {

/// Texels of a row of `from` that one of its copy of `to` texels covers, and how much of each: shares add up to 1.
struct Covered {
    int first, count;
    std::array<double, 3> share;
};

Covered covered_by(int i, int from, int to) {
    const double begin = double(i) * from / to, end = double(i + 1) * from / to;
    Covered covered{int(begin), 0, {}};
    for (int j = covered.first; j < from && double(j) < end && covered.count < 3; ++j) {
        const double part = std::min(end, j + 1.0) - std::max(begin, double(j));
        covered.share[std::size_t(covered.count++)] = part * to / from;
    }
    return covered;
}

unsigned char byte_of(double value) {
    return static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

/// The mean of texels, to which they are added one by one.
class Mean {
  public:
    explicit Mean(TexelKind kind) : kind_(kind) {}

    void add(const Rgba8& texel, double share) {
        const double weight = kind_ == TexelKind::colour ? share * texel.a : share;
        red_ += weight * linear(texel.r);
        green_ += weight * linear(texel.g);
        blue_ += weight * linear(texel.b);
        weight_ += weight;
        alpha_ += share * texel.a;
    }
    [[nodiscard]] Rgba8 value() const {
        const double scale = weight_ > 0.0 ? 1.0 / weight_ : 0.0;
        return {shown(red_ * scale), shown(green_ * scale), shown(blue_ * scale), byte_of(alpha_ / 255.0)};
    }

  private:
    [[nodiscard]] double linear(unsigned char byte) const {
        static const std::array<double, 256> light = [] {
            std::array<double, 256> table{};
            for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_decoded(double(i) / 255.0);
            return table;
        }();
        return kind_ == TexelKind::colour ? light[byte] : byte / 255.0;
    }
    [[nodiscard]] unsigned char shown(double value) const {
        return byte_of(kind_ == TexelKind::colour ? srgb_encoded(value) : value);
    }

    TexelKind kind_;
    double red_ = 0.0, green_ = 0.0, blue_ = 0.0, alpha_ = 0.0, weight_ = 0.0;
};

Image<Rgba8> half(const Image<Rgba8>& image, TexelKind kind) {
    Image<Rgba8> smaller(std::max(image.width / 2, 1), std::max(image.height / 2, 1));
    for (int y = 0; y < smaller.height; ++y) {
        const Covered rows = covered_by(y, image.height, smaller.height);
        for (int x = 0; x < smaller.width; ++x) {
            const Covered columns = covered_by(x, image.width, smaller.width);
            Mean mean(kind);
            for (int j = 0; j < rows.count; ++j)
                for (int i = 0; i < columns.count; ++i)
                    mean.add(image.at(columns.first + i, rows.first + j),
                             rows.share[std::size_t(j)] * columns.share[std::size_t(i)]);
            smaller.at(x, y) = mean.value();
        }
    }
    return smaller;
}

}  // namespace

Texture plain_texture(Image<Rgba8> image) {
    Texture texture;
    texture.levels.push_back(std::move(image));
    return texture;
}

Texture mip_mapped_texture(Image<Rgba8> image, TexelKind kind) {
    Texture texture = plain_texture(std::move(image));
    while (texture.levels.back().pixels.size() > 1) texture.levels.push_back(half(texture.levels.back(), kind));
    return texture;
}

}  // namespace kd
