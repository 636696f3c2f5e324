// A rectangle of values, row 0 at the top.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace kd {

template <class T>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;

    Image() = default;
    Image(int w, int h, const T& value = T{}) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), value) {}

    bool operator==(const Image&) const = default;

    [[nodiscard]] std::size_t index(int x, int y) const {
        assert(contains(x, y));
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
    [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    [[nodiscard]] T& at(int x, int y) { return pixels[index(x, y)]; }
    [[nodiscard]] const T& at(int x, int y) const { return pixels[index(x, y)]; }
    [[nodiscard]] bool empty() const { return pixels.empty(); }
};

/// 8-bit RGBA, straight alpha, display-referred (sRGB) colour.
struct Rgba8 {
    unsigned char r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Rgba8&) const = default;
};

}  // namespace kd
