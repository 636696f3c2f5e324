// Where in a picture rays go wrong: few places that lie apart, rather than every wrong pixel.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/trace/judged_layer.h"

namespace kd {

/// Pixels along x and y, the larger of both, that two places are more than apart: a 24th of the shorter side, at
/// least 8.
[[nodiscard]] int place_reach(int width, int height);

/// Indices of wrong pixels, those with most wrong pixels within reach first and those alike in rows. Any two are more
/// than place_reach() apart, and every wrong pixel lies within reach of one.
[[nodiscard]] std::vector<std::size_t> wrong_places(const Image<JudgedHit>& hits);

/// The place after the one that the pixel `from` lies at (before it where `backwards`), round and round; where it lies
/// at none, the nearest. Without `from` the first, or the last. Nothing where there is no place.
[[nodiscard]] std::optional<std::size_t> next_place(const JudgedLayer& judged, std::optional<std::size_t> from,
                                                    bool backwards);

}  // namespace kd
