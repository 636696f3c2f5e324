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
    explicit ListStack(std::vector<T> root) : items_(std::move(root)), begins_{0} {}
    ListStack() = default;

    void push(std::span<const T> list) {
        begins_.push_back(items_.size());
        items_.insert(items_.end(), list.begin(), list.end());
    }

    [[nodiscard]] std::span<const T> top() const { return std::span(items_).subspan(begins_.back()); }

    void drop() {
        items_.resize(begins_.back());
        begins_.pop_back();
    }

    /// A stack of the top list alone.
    [[nodiscard]] ListStack top_alone() const {
        const std::span<const T> list = top();
        return ListStack(std::vector<T>(list.begin(), list.end()));
    }

    /// Puts each entry where `sides_of(entry)` says, a union of side bits.
    template <class SidesOf>
    void divide(SidesOf sides_of) {
        const Dealt count = deal(sides_of);
        const std::size_t end_above = begins_.back() + count.above;
        items_.resize(end_above);
        items_.insert(items_.end(), below_.begin(), below_.begin() + std::ptrdiff_t(count.below));
        begins_.push_back(end_above);
    }

    /// As divide() of an ordered list, but entries of both sides (or none) are left out, and each side gets more, which
    /// are in order too.
    template <class SidesOf, class Before>
    void divide_and_merge(SidesOf sides_of, std::span<const T> more_below, std::span<const T> more_above,
                          Before is_before) {
        const std::size_t begin = begins_.back();
        const Dealt count = deal([&](const T& item) {
            const unsigned sides = sides_of(item);
            return sides == (side_below | side_above) ? 0u : sides;
        });
        const std::size_t end_above = begin + count.above + more_above.size();
        items_.resize(end_above + count.below + more_below.size());
        merge_back(items_.data() + begin, count.above, more_above, is_before);
        std::copy_n(below_.data(), count.below, items_.data() + end_above);
        merge_back(items_.data() + end_above, count.below, more_below, is_before);
        begins_.push_back(end_above);
    }

    /// Puts two given lists in the place of the top one.
    void replace_by(std::span<const T> above, std::span<const T> below) {
        items_.resize(begins_.back());
        items_.insert(items_.end(), above.begin(), above.end());
        begins_.push_back(items_.size());
        items_.insert(items_.end(), below.begin(), below.end());
    }

  private:
    struct Dealt {
        std::size_t below, above;
    };
    /// Entries of the top list that `sides_of` puts above stand first in it afterwards, those below in below_.
    template <class SidesOf>
    Dealt deal(SidesOf sides_of) {
        const std::size_t begin = begins_.back();
        const std::size_t size = items_.size() - begin;
        if (below_.size() < size) below_.resize(std::max(size, 2 * below_.size()));
        T* const items = items_.data() + begin;
        Dealt count{0, 0};
        // Written without branches: every entry is stored on both sides, and the counts decide which stores last.
        for (std::size_t i = 0; i < size; ++i) {
            const T item = items[i];
            const unsigned sides = sides_of(item);
            below_[count.below] = item;
            items[count.above] = item;
            count.below += sides & side_below;
            count.above += sides >> 1;
        }
        return count;
    }

    /// Merges `more` into `count` items with room behind them: from the back, so that nothing is overwritten that is
    /// still to be moved, and what lies before the first of `more` stays where it is.
    template <class Before>
    static void merge_back(T* items, std::size_t count, std::span<const T> more, Before is_before) {
        for (std::size_t left = more.size(); left > 0;) {
            const bool old_is_last = count > 0 && is_before(more[left - 1], items[count - 1]);
            const T last = old_is_last ? items[--count] : more[--left];
            items[count + left] = last;
        }
    }

    std::vector<T> items_;
    std::vector<std::size_t> begins_;
    std::vector<T> below_;  // room for one list
};

}  // namespace kd
