#include "renderer/measure/pixel_rays.h"

#include <algorithm>
#include <cmath>

#include "renderer/scene/random.h"

namespace kd {

namespace {

#include "shaders/shared/vector.glsl"
// After vector.glsl, whose functions it calls.
#include "shaders/shared/camera.glsl"

}  // namespace

std::vector<Ray> pixel_rays(const PinholeCamera& camera, int width, int height) {
    std::vector<Ray> rays;
    rays.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) rays.push_back(camera_ray(camera, int2(x, y), int2(width, height)));
    return rays;
}

std::vector<Ray> stratified_pixel_rays(const PinholeCamera& camera, int width, int height, int count, unsigned seed) {
    const int cells = std::max(1, int(std::sqrt(double(count))));
    Random random(seed);
    const auto pick = [&](int cell, int size) {
        const double position = (cell + random.unit()) / cells * size;
        return std::min(int(position), size - 1);
    };
    std::vector<Ray> rays;
    rays.reserve(std::size_t(cells) * std::size_t(cells));
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const int x = pick(column, width);
            const int y = pick(row, height);
            rays.push_back(camera_ray(camera, int2(x, y), int2(width, height)));
        }
    return rays;
}

}  // namespace kd
