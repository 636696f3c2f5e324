#include "renderer/trace/accumulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/cpu/threads.h"

namespace kd {

namespace {

void add_counters(RayCounters& sum, const RayCounters& c) {
    sum.interior_first += c.interior_first;
    sum.interior_again += c.interior_again;
    sum.leaves += c.leaves;
    sum.triangle_tests += c.triangle_tests;
    sum.restarts += c.restarts;
    sum.backtracks += c.backtracks;
    sum.stack_depth = std::max(sum.stack_depth, c.stack_depth);
    sum.exit_reason = std::max(sum.exit_reason, c.exit_reason);
    sum.rays += c.rays;
}

std::int64_t pixels_of(const Tile& tile) { return std::int64_t(tile.x1 - tile.x0) * (tile.y1 - tile.y0); }

/// Variance of the mean of n samples, as the mean over the channels.
double squared_error(const glm::dvec3& sum, const glm::dvec3& squares, int n) {
    const glm::dvec3 mean = sum / double(n);
    const glm::dvec3 variance = max(squares / double(n) - mean * mean, glm::dvec3(0));
    return (variance.x + variance.y + variance.z) / 3.0 / double(n - 1);
}

}  // namespace

Accumulator::Accumulator(int width, int height)
    : gathered_(width, height), sum_(gathered_.colour.pixels.size()), squares_(sum_.size()),
      tiles_(tiles_of(width, height, tile_size)), states_(tiles_.size()) {}

std::size_t Accumulator::number_of(const Tile& tile) const {
    const int columns = (gathered_.width + tile_size - 1) / tile_size;
    return std::size_t(tile.y0 / tile_size) * std::size_t(columns) + std::size_t(tile.x0 / tile_size);
}

void Accumulator::add(const Frame& sample, std::span<const Tile> tiles) {
    if (samples() == 0) {
        gathered_.exponent = sample.exponent;
        gathered_.sampling = sample.sampling;
        gathered_.hold_indirect(sample.holds(Pass::rt_indirect));
    }
    parallel_ranges(tiles.size(), 1, 0, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) add_tile(sample, tiles[i], states_[number_of(tiles[i])]);
    });
}

void Accumulator::add_tile(const Frame& sample, const Tile& tile, State& state) {
    ++state.samples;
    state.squared_error = 0;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t i = gathered_.colour.index(x, y);
            const glm::dvec3 colour(sample.colour.pixels[i]);
            sum_[i] += colour;
            squares_[i] += colour * colour;
            if (state.samples > 1) state.squared_error += squared_error(sum_[i], squares_[i], state.samples);
            for (std::size_t pass = 0; pass < pass_count; ++pass) {
                if (!gathered_.holds(Pass(pass))) continue;
                if (state.samples == 1) gathered_.layers[pass].hit.pixels[i] = sample.layers[pass].hit.pixels[i];
                add_counters(gathered_.layers[pass].counters.pixels[i], sample.layers[pass].counters.pixels[i]);
            }
        }
}

std::vector<Tile> Accumulator::active(double error) const {
    std::vector<Tile> found;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        const State& state = states_[i];
        const bool converged =
            state.samples >= fewest_samples && std::sqrt(state.squared_error / double(pixels_of(tiles_[i]))) <= error;
        if (!converged || error <= 0) found.push_back(tiles_[i]);
    }
    return found;
}

int Accumulator::samples() const {
    return states_.empty() ? 0 : std::ranges::max(states_, {}, &State::samples).samples;
}

double Accumulator::average_samples() const {
    double drawn = 0;
    for (std::size_t i = 0; i < tiles_.size(); ++i) drawn += double(states_[i].samples) * double(pixels_of(tiles_[i]));
    return sum_.empty() ? 0 : drawn / double(sum_.size());
}

double Accumulator::error() const {
    double squared = 0;
    for (const State& state : states_) {
        if (state.samples < 2) return std::numeric_limits<double>::infinity();
        squared += state.squared_error;
    }
    return sum_.empty() ? 0 : std::sqrt(squared / double(sum_.size()));
}

Frame Accumulator::frame() const {
    Frame frame = gathered_;
    for (const Tile& tile : tiles_) {
        const int n = states_[number_of(tile)].samples;
        if (n == 0) continue;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const std::size_t i = frame.colour.index(x, y);
                frame.colour.pixels[i] = Vec4(Vec3(sum_[i] / double(n)), 1.0f);
            }
    }
    return frame;
}

}  // namespace kd
