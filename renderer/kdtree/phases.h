// The time of a build by phase, without a clock call in every small cell.
#pragma once

#include <chrono>

#include "renderer/kdtree/build.h"

namespace kd {

/// Adds up what one thread does in its cells. Cells of many triangles are all timed; of the small ones every 16th is,
/// and counts 16 times, as a call of the clock takes as long as a decision about a few triangles.
class PhaseClock {
  public:
    explicit PhaseClock(BuildPhases& phases) : phases_(phases) {}

    /// Another cell, of so many triangles.
    void begin_cell(std::size_t triangles) {
        const bool large = triangles >= 512;
        weight_ = large ? 1.0 : ++small_ % sampled == 0 ? double(sampled) : 0.0;
        if (weight_ > 0) last_ = Clock::now();
    }

    /// What was done since the last call belongs to that phase.
    void end(double BuildPhases::*phase) {
        if (!(weight_ > 0)) return;
        const Clock::time_point now = Clock::now();
        phases_.*phase += weight_ * std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr unsigned sampled = 16;

    BuildPhases& phases_;
    Clock::time_point last_;
    double weight_ = 0;
    unsigned small_ = 0;
};

}  // namespace kd
