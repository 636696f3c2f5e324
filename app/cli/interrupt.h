// Ctrl-C as a stop request.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace kd {

/// Turns SIGINT and SIGTERM into a stop request while it lives; a second signal ends the program at once with code 130.
/// Made before any other thread, so that all of them leave these signals to it.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

  private:
    sigset_t signals_{};
    sigset_t before_{};
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace kd
