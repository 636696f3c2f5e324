// Pictures kept under tests/viz/golden. KD_UPDATE_GOLDEN=1 writes them anew; look at them before you commit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "renderer/io/png.h"

namespace kd::test {

/// Largest difference of a channel anywhere, and the share of pixels that may differ at all.
struct Tolerance {
    int channel = 0;
    double share = 0;
};

/// For lines: they go through square roots and divisions whose results may round differently with another compiler.
inline constexpr Tolerance of_lines{2, 0.001};

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

/// Success where the pictures agree. Otherwise NAME.actual.png, and where the sizes agree NAME.diff.png, are written to
/// the tests' output folder, and the message says what differs and where to look.
[[nodiscard]] inline testing::AssertionResult compare_pictures(const Image<Rgba8>& actual, const Image<Rgba8>& expected,
                                                               const std::string& name, Tolerance tolerance) {
    const std::filesystem::path actual_path = std::filesystem::path(KD_TEST_OUTPUT_DIR) / (name + ".actual.png");
    const std::filesystem::path diff_path = std::filesystem::path(KD_TEST_OUTPUT_DIR) / (name + ".diff.png");
    if (actual.width != expected.width || actual.height != expected.height) {
        write_png(actual_path, actual);
        return testing::AssertionFailure() << name << ": " << actual.width << "x" << actual.height << " instead of "
                                           << expected.width << "x" << expected.height << "; see " << actual_path;
    }
    std::size_t differing = 0;
    int largest = 0;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        const int difference = largest_difference(actual.pixels[i], expected.pixels[i]);
        largest = std::max(largest, difference);
        differing += difference > 0 ? 1 : 0;
    }
    const bool few = double(differing) <= tolerance.share * double(actual.pixels.size());
    if (few && largest <= tolerance.channel) return testing::AssertionSuccess();
    write_png(actual_path, actual);
    write_png(diff_path, difference_image(actual, expected));
    return testing::AssertionFailure() << name << ": " << differing << " of " << actual.pixels.size()
                                       << " pixels differ, by " << largest << "/255 at most; see " << actual_path
                                       << " and " << diff_path;
}

/// Passes where `actual` is the picture tests/viz/golden/NAME.png.
inline void expect_golden(const Image<Rgba8>& actual, const std::string& name, Tolerance tolerance = {}) {
    const std::filesystem::path path = std::filesystem::path(KD_SOURCE_DIR) / "tests/viz/golden" / (name + ".png");
    const char* const update = std::getenv("KD_UPDATE_GOLDEN");
    if (update != nullptr && std::string(update) == "1") {
        write_png(path, actual);
    } else if (std::filesystem::exists(path)) {
        EXPECT_TRUE(compare_pictures(actual, read_png(path), name, tolerance));
    } else {
        ADD_FAILURE() << path << " is missing; make it with KD_UPDATE_GOLDEN=1";
    }
}

}  // namespace kd::test
