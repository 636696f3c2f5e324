#include "renderer/measure/error_time/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace kd {

namespace {

using Plane = Flip::Plane;
using Colour = glm::dvec3;
constexpr double pi = std::numbers::pi;

// --- Colour spaces: linear RGB of sRGB's primaries, D65 ---

double linear(double displayed) {
    const double v = std::clamp(displayed, 0.0, 1.0);
    return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

// Rows of RGB to XYZ, each divided by the white's: white is (1, 1, 1).
constexpr double white[3] = {0.950428545, 1.0, 1.088900371};
constexpr double to_xyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
constexpr double from_xyz[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                   {-0.969224334, 1.875930071, 0.041554224},
                                   {0.055639423, -0.204011202, 1.057148933}};

Colour times(const double (&m)[3][3], const Colour& v) {
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

Colour relative_xyz(const Colour& rgb) { return times(to_xyz, rgb) / Colour(white[0], white[1], white[2]); }

/// Luminance and two opponent colours, linear in light: what the eye filters.
Colour opponent(const Colour& rgb) {
    const Colour v = relative_xyz(rgb);
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

Colour rgb_of(const Colour& o) {
    const double y = (o.x + 16) / 116;
    return times(from_xyz, Colour((y + o.y / 500) * white[0], y, (y - o.z / 200) * white[2]));
}

/// CIELAB whose colours fade with the light, as Hunt found.
Colour hunt_lab(const Colour& rgb) {
    const auto root = [](double v) {
        constexpr double d = 6.0 / 29;
        return v > d * d * d ? std::cbrt(v) : v / (3 * d * d) + 4.0 / 29;
    };
    const Colour v = relative_xyz(rgb);
    const double l = 116 * root(v.y) - 16;
    return {l, 0.01 * l * 500 * (root(v.x) - root(v.y)), 0.01 * l * 200 * (root(v.y) - root(v.z))};
}

double distance(const Colour& a, const Colour& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);  // HyAB
}

// --- Filters: all are sums of products of a filter along x and one along y ---

struct Filter {
    std::vector<double> weights;  // 2 * radius + 1
    [[nodiscard]] int radius() const { return int(weights.size()) / 2; }
};

template <class Shape>
Filter sampled(int radius, const Shape& shape) {
    Filter filter;
    for (int i = -radius; i <= radius; ++i) filter.weights.push_back(shape(double(i)));
    return filter;
}

/// Positive weights sum to 1, negative ones to -1.
Filter balanced(Filter filter) {
    double positive = 0, negative = 0;
    for (const double w : filter.weights) (w > 0 ? positive : negative) += w;
    for (double& w : filter.weights)
        if (w != 0) w /= w > 0 ? positive : -negative;
    return filter;
}

struct Size {
    int width, height;
};

/// Beyond the border the nearest pixel counts.
Plane filtered(const Plane& plane, Size size, const Filter& along_x, const Filter& along_y) {
    const auto pass = [&](const Plane& from, const Filter& filter, bool horizontal) {
        Plane to(from.size());
        const int r = filter.radius();
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double sum = 0;
                for (int i = -r; i <= r; ++i) {
                    const int u = horizontal ? std::clamp(x + i, 0, size.width - 1) : x;
                    const int v = horizontal ? y : std::clamp(y + i, 0, size.height - 1);
                    sum += filter.weights[std::size_t(i + r)] *
                           from[std::size_t(v) * std::size_t(size.width) + std::size_t(u)];
                }
                to[std::size_t(y) * std::size_t(size.width) + std::size_t(x)] = sum;
            }
        return to;
    };
    return pass(pass(plane, along_x, true), along_y, false);
}

/// a * sqrt(pi / b) * exp(-(pi x)^2 / b), x in degrees: the eye's sensitivity to contrast in one channel (table 1 of
/// the paper), as sums of two.
struct Sensitivity {
    double a[2], b[2];
};
constexpr Sensitivity sensitivities[3] = {
    {{1, 0}, {0.0047, 1e-5}}, {{1, 0}, {0.0053, 1e-5}}, {{34.1, 13.5}, {0.04, 0.025}}};

/// The channel as the eye at this distance resolves it.
Plane eye_filtered(const Plane& plane, Size size, const Sensitivity& s, double pixels_per_degree) {
    constexpr double widest = 0.04;
    const int radius = int(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
    Plane sum(plane.size(), 0.0);
    double weight = 0;
    for (int k = 0; k < 2; ++k) {
        if (s.a[k] == 0) continue;
        const Filter filter = sampled(radius, [&](double i) {
            const double degrees = i / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / s.b[k]);
        });
        double line = 0;
        for (const double w : filter.weights) line += w;
        const double amplitude = s.a[k] * std::sqrt(pi / s.b[k]);
        const Plane part = filtered(plane, size, filter, filter);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += amplitude * part[i];
        weight += amplitude * line * line;
    }
    for (double& v : sum) v /= weight;
    return sum;
}

enum class Feature { edge, point };

/// The length of the gradient (edges) or of the second derivatives (points) of the lightness, per pixel.
Plane feature_strength(const Plane& lightness, Size size, Feature feature, double pixels_per_degree) {
    constexpr double width_in_degrees = 0.082;
    const double deviation = 0.5 * width_in_degrees * pixels_per_degree;
    const int radius = int(std::ceil(3 * deviation));
    const auto bell = [&](double i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    const Filter derivative = balanced(sampled(radius, [&](double i) {
        return feature == Feature::edge ? -i * bell(i) : (i * i / (deviation * deviation) - 1) * bell(i);
    }));
    const Filter smooth = balanced(sampled(radius, bell));
    const Plane across = filtered(lightness, size, derivative, smooth);
    const Plane down = filtered(lightness, size, smooth, derivative);
    Plane strength(lightness.size());
    for (std::size_t i = 0; i < strength.size(); ++i) strength[i] = std::hypot(across[i], down[i]);
    return strength;
}

Flip::Seen see(const Image<Colour>& image, double pixels_per_degree) {
    const Size size{image.width, image.height};
    std::array<Plane, 3> channels;
    Plane lightness;
    for (const Colour& displayed : image.pixels) {
        const Colour o = opponent({linear(displayed.x), linear(displayed.y), linear(displayed.z)});
        for (int c = 0; c < 3; ++c) channels[std::size_t(c)].push_back(o[c]);
        lightness.push_back((o.x + 16) / 116);
    }
    Flip::Seen seen;
    for (std::size_t c = 0; c < 3; ++c)
        seen.lab[c] = eye_filtered(channels[c], size, sensitivities[c], pixels_per_degree);
    for (std::size_t i = 0; i < lightness.size(); ++i) {
        const Colour rgb = rgb_of({seen.lab[0][i], seen.lab[1][i], seen.lab[2][i]});
        const Colour lab = hunt_lab(glm::clamp(rgb, Colour(0), Colour(1)));
        for (int c = 0; c < 3; ++c) seen.lab[std::size_t(c)][i] = lab[c];
    }
    seen.features = {feature_strength(lightness, size, Feature::edge, pixels_per_degree),
                     feature_strength(lightness, size, Feature::point, pixels_per_degree)};
    return seen;
}

/// A colour's distance on a scale of 0 to 1: below 0.4 of the largest distance linear up to 0.95, the rest above.
double redistributed(double distance_to_power, double largest) {
    constexpr double knee = 0.4, knee_value = 0.95;
    const double at = knee * largest;
    if (distance_to_power < at) return distance_to_power * knee_value / at;
    return knee_value + (distance_to_power - at) / (largest - at) * (1 - knee_value);
}

}  // namespace

Flip::Flip(const Image<glm::dvec3>& reference, double pixels_per_degree)
    : pixels_per_degree_(pixels_per_degree), width_(reference.width), height_(reference.height),
      reference_(see(reference, pixels_per_degree)) {}

Image<double> Flip::map(const Image<glm::dvec3>& image) const {
    assert(image.width == width_ && image.height == height_);
    constexpr double colour_power = 0.7, feature_power = 0.5;
    const double largest = std::pow(distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), colour_power);
    const Seen seen = see(image, pixels_per_degree_);
    Image<double> differences(width_, height_);
    for (std::size_t i = 0; i < differences.pixels.size(); ++i) {
        const auto lab = [i](const Seen& s) { return Colour(s.lab[0][i], s.lab[1][i], s.lab[2][i]); };
        const auto apart = [&](std::size_t f) { return std::abs(seen.features[f][i] - reference_.features[f][i]); };
        const double colour = redistributed(std::pow(distance(lab(seen), lab(reference_)), colour_power), largest);
        const double feature = std::pow(std::max(apart(0), apart(1)) / std::numbers::sqrt2, feature_power);
        differences.pixels[i] = std::pow(colour, 1 - feature);
    }
    return differences;
}

double Flip::mean(const Image<glm::dvec3>& image) const {
    const Image<double> differences = map(image);
    double sum = 0;
    for (const double d : differences.pixels) sum += d;
    return differences.pixels.empty() ? 0 : sum / double(differences.pixels.size());
}

}  // namespace kd
