// How far the threads of a build are together.
#pragma once

#include <algorithm>
#include <mutex>

#include "renderer/kdtree/build.h"

namespace kd {

/// Adds up what threads have done, and tells it in steps.
class SharedProgress {
  public:
    /// The smallest step that is told.
    static constexpr double least_step = 0.01;

    explicit SharedProgress(const BuildProgress& progress) : progress_(progress) {}

    /// `work` is a share of the whole, 0..1. Any thread may call.
    void advance(double work) {
        if (!progress_) return;
        const std::scoped_lock lock(mutex_);
        done_ += work;
        if (done_ < next_told_) return;
        progress_(float(std::min(done_, 1.0)));
        next_told_ = done_ + least_step;
    }

    void end() {
        if (progress_) progress_(1.0f);
    }

  private:
    const BuildProgress& progress_;
    std::mutex mutex_;
    double done_ = 0.0, next_told_ = least_step;
};

}  // namespace kd
