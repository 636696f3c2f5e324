// What the threads of a build have in common.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

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

/// How many references may still go to leaves. Threads may spend more than there is; then what they build is not a tree
/// to keep.
class ReferenceBudget {
  public:
    explicit ReferenceBudget(std::int64_t references) : left_(references) {}

    void spend(std::int64_t references) { left_.fetch_sub(references, std::memory_order_relaxed); }
    [[nodiscard]] bool is_overspent() const { return left_.load(std::memory_order_relaxed) < 0; }

  private:
    std::atomic<std::int64_t> left_;
};

/// Side bits by triangle number (CellLists::swap_room()): as many as threads ask at once, each handed on to the next
/// part as it is. One for each part would take time in proportion to the square of the triangles.
class SharedRooms {
  public:
    using Room = std::vector<std::uint8_t>;

    [[nodiscard]] Room take() {
        const std::scoped_lock lock(mutex_);
        if (rooms_.empty()) return {};
        Room room = std::move(rooms_.back());
        rooms_.pop_back();
        return room;
    }
    void give_back(Room room) {
        const std::scoped_lock lock(mutex_);
        rooms_.push_back(std::move(room));
    }

  private:
    std::mutex mutex_;
    std::vector<Room> rooms_;
};

struct GrowersShare {
    GrowersShare(const BuildProgress& told, std::int64_t references) : progress(told), budget(references) {}

    SharedProgress progress;
    ReferenceBudget budget;
    SharedRooms rooms;
};

}  // namespace kd
