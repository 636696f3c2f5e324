// Violations as they are found, up to a limit.
#pragma once

#include "renderer/kdtree/validate.h"

namespace kd {

class Findings {
  public:
    explicit Findings(std::size_t limit) : limit_(limit) {}

    void add(int node, std::string message) {
        if (!full()) list_.push_back({node, std::move(message)});
    }

    /// Nothing more is taken; the search may stop.
    [[nodiscard]] bool full() const { return list_.size() >= limit_; }
    [[nodiscard]] bool none() const { return list_.empty(); }
    [[nodiscard]] std::vector<Violation> take() { return std::move(list_); }

  private:
    std::size_t limit_;
    std::vector<Violation> list_;
};

}  // namespace kd
