// The time of a build by phase, without a clock call in every small cell.
#pragma once

#include <time.h>

#include <chrono>

#include "renderer/kdtree/build.h"

namespace kd {

/// Adds up what one thread does in its cells. Cells of many triangles are all timed; of the small ones every 16th is,
/// and counts 16 times, as a call of the clock takes as long as a decision about a few triangles.
class PhaseClock {
  public:
    /// For the thread that calls.
    explicit PhaseClock(BuildPhases& phases) : phases_(phases), begin_(processor_time()) {}

    /// Another cell, of so many triangles.
    void begin_cell(std::size_t triangles) {
        is_small_ = triangles < 512;
        weight_ = !is_small_ ? 1.0 : ++small_ % sampled == 0 ? double(sampled) : 0.0;
        if (weight_ > 0) last_ = Clock::now();
    }

    /// What was done since the last call belongs to that phase.
    void end(double BuildPhases::*phase) {
        if (!(weight_ > 0)) return;
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        if (!is_small_ || seconds < interrupted) phases_.*phase += weight_ * seconds;
    }

    /// The phases take no more than the thread's processor time since it began: interruptions and samples that counted
    /// for more than they stood for are taken out in proportion.
    void finish() {
        const double most = processor_time() - begin_, sum = phases_.sum();
        if (sum > most) phases_.scale(most / sum);
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr unsigned sampled = 16;
    static constexpr double interrupted = 1e-3;  // s; a phase of a small cell takes some microseconds

    static double processor_time() {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }

    BuildPhases& phases_;
    double begin_;
    Clock::time_point last_;
    double weight_ = 0;
    unsigned small_ = 0;
    bool is_small_ = false;
};

}  // namespace kd
