// The transfer function of sRGB.
#pragma once

#include <cmath>

namespace kd {

/// Light, linear, 0..1, as the number that is stored and displayed, 0..1 (IEC 61966-2-1), and back.
[[nodiscard]] inline double srgb_encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}
[[nodiscard]] inline double srgb_decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace kd
