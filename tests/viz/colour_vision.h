// How far apart colours look, with full colour vision and without the green-sensitive cones.
#pragma once

#include <array>
#include <cmath>

#include "renderer/geometry/image.h"

namespace kd::test {

using Triple = std::array<double, 3>;

/// Linear light, 0..1 (IEC 61966-2-1).
inline Triple linear_rgb(Rgba8 c) {
    const auto linear = [](unsigned char channel) {
        const double v = channel / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return {linear(c.r), linear(c.g), linear(c.b)};
}

/// Relative luminance.
inline double luminance(Rgba8 c) {
    const Triple rgb = linear_rgb(c);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

inline Triple multiply(const std::array<Triple, 3>& m, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// CIE L*a*b* for a D65 white, from linear sRGB.
inline Triple lab(const Triple& rgb) {
    constexpr std::array<Triple, 3> to_xyz{
        {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
    const Triple xyz = multiply(to_xyz, rgb);
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const double x = f(xyz[0] / 0.95047);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// What remains of a colour in deuteranopia (Machado, Oliveira & Fernandes, "A Physiologically-based Model for
/// Simulation of Color Vision Deficiency", 2009, severity 1).
inline Triple without_green_cones(const Triple& rgb) {
    constexpr std::array<Triple, 3> model{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    Triple seen = multiply(model, rgb);
    for (double& channel : seen) channel = std::fmin(std::fmax(channel, 0.0), 1.0);
    return seen;
}

/// CIE76 difference: 2.3 is just noticeable side by side.
inline double difference(const Triple& a, const Triple& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The smaller of what people with full colour vision and with deuteranopia see.
inline double least_difference(Rgba8 a, Rgba8 b) {
    const Triple p = linear_rgb(a);
    const Triple q = linear_rgb(b);
    return std::fmin(difference(lab(p), lab(q)), difference(lab(without_green_cones(p)), lab(without_green_cones(q))));
}

}  // namespace kd::test
