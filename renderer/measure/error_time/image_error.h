// Images of averaged samples, and how far they are from a reference.
#pragma once

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

/// Colours as the tracers give them, averaged in double: neither rounded nor clipped.
class SampleMean {
  public:
    SampleMean(int width, int height) : sum_(width, height, glm::dvec3(0)) {}

    void add(const Image<Vec4>& colour) {
        for (std::size_t i = 0; i < sum_.pixels.size(); ++i) sum_.pixels[i] += glm::dvec3(colour.pixels[i]);
        ++samples_;
    }
    void add(const Image<glm::dvec3>& colour) {
        for (std::size_t i = 0; i < sum_.pixels.size(); ++i) sum_.pixels[i] += colour.pixels[i];
        ++samples_;
    }
    [[nodiscard]] int samples() const { return samples_; }
    [[nodiscard]] Image<glm::dvec3> mean() const {
        Image<glm::dvec3> mean = sum_;
        for (glm::dvec3& pixel : mean.pixels) pixel /= double(samples_);
        return mean;
    }

  private:
    Image<glm::dvec3> sum_;
    int samples_ = 0;
};

/// Mean over pixels and channels of the squared difference. The images are of one size.
[[nodiscard]] inline double mean_square_error(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 d = a.pixels[i] - b.pixels[i];
        sum += d.x * d.x + d.y * d.y + d.z * d.z;
    }
    return a.pixels.empty() ? 0 : sum / double(3 * a.pixels.size());
}

}  // namespace kd
