#include "renderer/measure/error_time/sampling.h"

#include <utility>

#include "renderer/scene/random.h"

namespace kd {

namespace {

/// The largest divisor that is no larger than the root.
int rows_of(int count) {
    int rows = 1;
    for (int r = 1; r * r <= count; ++r)
        if (count % r == 0) rows = r;
    return rows;
}

}  // namespace

std::vector<glm::dvec2> sample_offsets(Sampler sampler, int count, std::uint64_t seed) {
    Random random(seed);
    const int rows = rows_of(count);
    const int columns = count / rows;
    std::vector<glm::dvec2> offsets;
    for (int i = 0; i < count; ++i) {
        const double u = sampler == Sampler::regular ? 0.5 : random.unit();
        const double v = sampler == Sampler::regular ? 0.5 : random.unit();
        if (sampler == Sampler::independent)
            offsets.emplace_back(u - 0.5, v - 0.5);
        else
            offsets.emplace_back((i % columns + u) / columns - 0.5, (i / columns + v) / rows - 0.5);
    }
    // A picture that ends between two sets has seen cells from everywhere in the pixel.
    if (sampler == Sampler::stratified)
        for (std::size_t left = offsets.size(); left > 1; --left)
            std::swap(offsets[left - 1], offsets[std::size_t(random.unit() * double(left))]);
    return offsets;
}

PinholeCamera shifted(const PinholeCamera& camera, glm::dvec2 offset, int width, int height) {
    // A pixel is 2/width of `right` wide and 2/height of `up` high.
    PinholeCamera moved = camera;
    moved.forward = Vec3(glm::dvec3(camera.forward) + glm::dvec3(camera.right) * (2 * offset.x / width) -
                         glm::dvec3(camera.up) * (2 * offset.y / height));
    return moved;
}

}  // namespace kd
