// The image that others are measured against, and how far it may be off itself.
#pragma once

#include <functional>
#include <stop_token>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

/// The mean of two halves of disjoint samples; what it may be off by follows from their difference.
struct ReferenceImage {
    Image<glm::dvec3> mean;
    double rmse = 0;          // half the root mean square difference of the halves
    double relative_mse = 0;  // the same as relative_mean_square_error() has it
};

/// One sample of a half, both from 0.
using ReferenceFrame = std::function<Image<glm::dvec3>(int half, int sample)>;

/// Of `samples` frames of width x height, at least 2; one more where their number is odd. No image where stopped.
[[nodiscard]] ReferenceImage reference_of_halves(int width, int height, int samples, const ReferenceFrame& frame,
                                                 const std::function<void(float)>& progress,
                                                 const std::stop_token& stop);

}  // namespace kd
