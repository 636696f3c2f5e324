// Pictures kept under tests/viz/golden. KD_UPDATE_GOLDEN=1 writes them anew; look at them before you commit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "renderer/io/png.h"

namespace kd::test {

/// Largest difference of a channel, and the share of pixels that may differ by more than that.
struct Tolerance {
    int channel = 0;
    double outliers = 0;
};

inline int largest_difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

/// Grey where equal, brighter where they differ more.
inline Image<Rgba8> difference_image(const Image<Rgba8>& a, const Image<Rgba8>& b) {
    Image<Rgba8> result(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto level = static_cast<unsigned char>(std::min(largest_difference(a.pixels[i], b.pixels[i]) * 8, 255));
        result.pixels[i] = {level, level, level, 255};
    }
    return result;
}

/// Passes where `actual` is the picture tests/viz/golden/NAME.png. Otherwise NAME.actual.png and NAME.diff.png are
/// written.
inline void expect_golden(const Image<Rgba8>& actual, const std::string& name, Tolerance tolerance = {}) {
    const std::filesystem::path path = std::filesystem::path(KD_SOURCE_DIR) / "tests/viz/golden" / (name + ".png");
    const char* const update = std::getenv("KD_UPDATE_GOLDEN");
    if (update != nullptr && std::string(update) == "1") {
        write_png(path, actual);
        return;
    }
    const std::filesystem::path out = KD_TEST_OUTPUT_DIR;
    if (!std::filesystem::exists(path)) {
        write_png(out / (name + ".actual.png"), actual);
        FAIL() << path << " is missing; make it with KD_UPDATE_GOLDEN=1";
    }
    const Image<Rgba8> expected = read_png(path);
    if (actual.width != expected.width || actual.height != expected.height) {
        write_png(out / (name + ".actual.png"), actual);
        FAIL() << name << ": " << actual.width << "x" << actual.height << " instead of " << expected.width << "x"
               << expected.height << "; see " << out / (name + ".actual.png");
    }
    std::size_t outliers = 0;
    int largest = 0;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        const int difference = largest_difference(actual.pixels[i], expected.pixels[i]);
        largest = std::max(largest, difference);
        outliers += difference > tolerance.channel ? 1 : 0;
    }
    if (double(outliers) <= tolerance.outliers * double(actual.pixels.size())) return;
    write_png(out / (name + ".actual.png"), actual);
    write_png(out / (name + ".diff.png"), difference_image(actual, expected));
    FAIL() << name << ": " << outliers << " of " << actual.pixels.size() << " pixels differ by more than "
           << tolerance.channel << "/255 (largest " << largest << "); see " << out / (name + ".diff.png");
}

}  // namespace kd::test
