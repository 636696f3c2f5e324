// How many references the threads of a build may still hand to leaves, together.
#pragma once

#include <atomic>
#include <cstdint>

namespace kd {

/// Threads may spend more than there is; then what they build is not a tree to keep.
class ReferenceBudget {
  public:
    explicit ReferenceBudget(std::int64_t references) : left_(references) {}

    void spend(std::int64_t references) { left_.fetch_sub(references, std::memory_order_relaxed); }
    [[nodiscard]] bool is_overspent() const { return left_.load(std::memory_order_relaxed) < 0; }

  private:
    std::atomic<std::int64_t> left_;
};

}  // namespace kd
