// One line on the terminal that says how far the work is.
#pragma once

#include <chrono>
#include <iosfwd>
#include <mutex>
#include <string>

#include "app/cli/command.h"

namespace kd {

/// A whole line for work that takes minutes, where `err` is no terminal that could show how far it is.
void tell_work(const CommandContext& context, const std::string& what);

/// Draws only where the context's `err` is a terminal; wiped at the end of the scope.
class ProgressLine {
  public:
    explicit ProgressLine(const CommandContext& context) : err_(context.err), shown_(context.progress) {}
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// From any thread; `fraction` is 0..1. At most ten times a second.
    void show(float fraction, const std::string& what);
    /// Makes room for lines on the same terminal; shown again with the next show().
    void wipe();

  private:
    std::ostream& err_;
    bool shown_;
    bool drawn_ = false;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace kd
