// Frames of samples gathered into the picture that they are samples of, tile by tile, until it is certain enough.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

/// Means of colours, sums of counters. A tile is *converged* once the standard error of its pixels' means, root mean
/// square over pixels and channels, is at most what is asked for. The error is estimated as for independent samples;
/// points of low discrepancy do better, so that it is more often too large than too small.
class Accumulator {
  public:
    static constexpr int tile_size = 32;
    static constexpr int fewest_samples = 16;  // before a tile may be said to have converged

    Accumulator(int width, int height);

    /// Adds what a frame of samples has in `tiles`, which are some of tiles(); the first time all of them.
    void add(const Frame& sample, std::span<const Tile> tiles);

    [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
    /// Tiles that have not converged to `error` (colours of 0..1); all where that is 0.
    [[nodiscard]] std::vector<Tile> active(double error) const;

    /// Samples of the pixel that has most.
    [[nodiscard]] int samples() const;
    /// Of all pixels.
    [[nodiscard]] double average_samples() const;
    /// Root mean square of the standard errors over all pixels; infinite below two samples.
    [[nodiscard]] double error() const;

    /// Mean colours, sums of counters (maxima of stack depths and exit reasons), and the hits, with
    /// Frame::sampling, of the first sample. Untraced where there is none.
    [[nodiscard]] Frame frame() const;

  private:
    /// Of one tile.
    struct State {
        int samples = 0;
        double squared_error = 0;  // sum over pixels of the mean over channels
    };

    Frame gathered_;
    std::vector<glm::dvec3> sum_, squares_;
    std::vector<Tile> tiles_;
    std::vector<State> states_;

    [[nodiscard]] std::size_t number_of(const Tile& tile) const;
    void add_tile(const Frame& sample, const Tile& tile, State& state);
};

}  // namespace kd
