// The lists of all unfinished cells, in one block of memory: a depth-first build only ever works on the last one.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "renderer/kdtree/split.h"

namespace kd {

/// A stack of lists of T. Dividing the top list in two puts the list above the split in its place and the list below on
/// top of that, both in the old order.
template <class T>
class ListStack {
  public:
    /// Starts with one list.
    explicit ListStack(std::vector<T> root) : items_(std::move(root)) {}

    [[nodiscard]] std::span<const T> top() const { return std::span(items_).subspan(begins_.back()); }

    void drop() {
        items_.resize(begins_.back());
        begins_.pop_back();
    }

    /// Puts each entry where `sides_of(entry)` says, a union of side bits.
    template <class SidesOf>
    void divide(SidesOf sides_of) {
        const std::size_t begin = begins_.back();
        const std::size_t size = items_.size() - begin;
        if (below_.size() < size) below_.resize(std::max(size, 2 * below_.size()));
        T* const items = items_.data() + begin;
        std::size_t below = 0;
        std::size_t above = 0;
        // Written without branches: every entry is stored on both sides, and the counts decide which stores last.
        for (std::size_t i = 0; i < size; ++i) {
            const T item = items[i];
            const unsigned sides = sides_of(item);
            below_[below] = item;
            items[above] = item;
            below += sides & side_below;
            above += sides >> 1;
        }
        items_.resize(begin + above);
        items_.insert(items_.end(), below_.begin(), below_.begin() + std::ptrdiff_t(below));
        begins_.push_back(begin + above);
    }

    /// Puts two given lists in the place of the top one.
    void replace_by(std::span<const T> above, std::span<const T> below) {
        items_.resize(begins_.back());
        items_.insert(items_.end(), above.begin(), above.end());
        begins_.push_back(items_.size());
        items_.insert(items_.end(), below.begin(), below.end());
    }

  private:
    std::vector<T> items_;
    std::vector<std::size_t> begins_{0};
    std::vector<T> below_;  // room for one list
};

}  // namespace kd
