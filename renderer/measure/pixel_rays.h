// Primary rays as a list, for checks that trace rays and not pictures.
#pragma once

#include <vector>

#include "renderer/geometry/shared_types.h"

namespace kd {

/// The ray of every pixel of a width x height picture, row by row.
[[nodiscard]] std::vector<Ray> pixel_rays(const PinholeCamera& camera, int width, int height);

/// Rays of pixels drawn at random, one from each cell of a square grid over the picture; the largest square number of
/// cells that is not above `count`.
[[nodiscard]] std::vector<Ray> stratified_pixel_rays(const PinholeCamera& camera, int width, int height, int count,
                                                     unsigned seed);

}  // namespace kd
