// Whether a list of a tile's pixels is worth making: what was found when it was made last. No GL.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "renderer/trace/frame.h"

namespace kd {

/// Where few lanes would idle a pass over all pixels is faster than one over a list, for each thread finds in its cache
/// what it has stored the pass before (docs/performance.md). A list has to be made to be found full; so where one was
/// found full none is made for some frames. Frames are cut into tiles that are never the same, so that rows are
/// remembered.
class ListFill {
  public:
    /// Of the lanes that a list's pixels come from: above it all pixels are passed over.
    static constexpr double full_enough = 0.9;
    /// Passed over without a look: a camera in motion is followed within as many frames, and a sixteenth of a list's
    /// time is not seen in any measurement.
    static constexpr int tiles_between_looks = 15;

    /// Asked once whenever a tile of a frame of `height` rows is passed over: true where a list is to be made.
    [[nodiscard]] bool asks_for_list(const Tile& tile, int height) {
        const std::span<int> bands = bands_of(tile, height);
        if (bands.empty() || std::ranges::find(bands, 0) != bands.end()) return true;
        for (int& left : bands) --left;
        return false;
    }

    /// What the list of the tile was found to be: `filled` of its lanes have a pixel. True where it is to be used.
    bool keeps_list(const Tile& tile, int height, double filled) {
        const bool full = filled > full_enough;
        std::ranges::fill(bands_of(tile, height), full ? tiles_between_looks : 0);
        return !full;
    }

  private:
    static constexpr int bands_of_a_frame = 16;
    std::array<int, bands_of_a_frame> left_{};  // tiles that each band is still known to be full for

    /// Those that the tile touches; none where it is empty.
    [[nodiscard]] std::span<int> bands_of(const Tile& tile, int height) {
        if (tile.y0 >= tile.y1) return {};
        const int first = tile.y0 * bands_of_a_frame / height, last = (tile.y1 - 1) * bands_of_a_frame / height;
        return std::span(left_).subspan(std::size_t(first), std::size_t(last - first + 1));
    }
};

}  // namespace kd
