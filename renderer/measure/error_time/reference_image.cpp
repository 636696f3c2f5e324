#include "renderer/measure/error_time/reference_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/relative_error.h"

namespace kd {

ReferenceImage reference_of_halves(int width, int height, int samples, const ReferenceFrame& frame,
                                   const std::function<void(float)>& progress, const std::stop_token& stop) {
    const int per_half = std::max(1, (samples + 1) / 2);
    std::array<Image<glm::dvec3>, 2> halves;
    for (int half = 0; half < 2; ++half) {
        SampleMean mean(width, height);
        for (int sample = 0; sample < per_half; ++sample) {
            if (stop.stop_requested()) return {};
            mean.add(frame(half, sample));
            if (progress) progress(float(half * per_half + sample + 1) / float(2 * per_half));
        }
        halves[std::size_t(half)] = mean.mean();
    }
    SampleMean both(width, height);
    for (const auto& half : halves) both.add(half);
    ReferenceImage reference{both.mean()};
    // Each half's variance is twice that of their mean, and that of their difference is twice a half's.
    reference.rmse = 0.5 * std::sqrt(mean_square_error(halves[0], halves[1]));
    reference.relative_mse = 0.25 * weighted_square_error(halves[0], halves[1], reference.mean);
    return reference;
}

}  // namespace kd
