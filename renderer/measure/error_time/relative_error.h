// relMSE: errors of sampled light in proportion to the light.
#pragma once

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

/// What keeps dark pixels from deciding all of it (Rousselle, Knaus and Zwicker, "Adaptive Sampling and Reconstruction
/// using Greedy Error Minimization", SIGGRAPH Asia 2011).
inline constexpr double relative_error_floor = 0.01;

/// Mean over pixels and channels of (a - b)^2 / (level^2 + relative_error_floor). The images are of one size.
[[nodiscard]] inline double weighted_square_error(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b,
                                                  const Image<glm::dvec3>& level) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const double difference = a.pixels[i][channel] - b.pixels[i][channel], of = level.pixels[i][channel];
            sum += difference * difference / (of * of + relative_error_floor);
        }
    return a.pixels.empty() ? 0 : sum / double(3 * a.pixels.size());
}

/// relMSE: the error squared over the reference squared.
[[nodiscard]] inline double relative_mean_square_error(const Image<glm::dvec3>& image,
                                                       const Image<glm::dvec3>& reference) {
    return weighted_square_error(image, reference, reference);
}

}  // namespace kd
