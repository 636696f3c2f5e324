// How long people wait: the time from every input to the frame that answers it, as a CSV file.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "app/engine/state.h"

namespace kd {

/// Milliseconds since 1970: a clock that another program, which sends inputs, reads as well.
[[nodiscard]] double system_ms();

/// Does nothing unless it was given a file. An event is taken up by the first frame presented after it was applied:
/// what was moved or pressed shows it. It is answered by the first frame whose picture is (at least a preview) of the
/// session that the event led to. Those that never were are written at the end, with nothing for that frame's time and
/// the latency.
class EventLog {
  public:
    /// Throws InputError where `path` cannot be written; empty: off.
    explicit EventLog(const std::string& path);
    ~EventLog();
    EventLog(const EventLog&) = delete;
    EventLog& operator=(const EventLog&) = delete;

    /// The window takes an input at `now_ms`.
    void input(const char* kind, double now_ms);
    /// All inputs so far are part of the session with this generation.
    void applied(std::uint64_t generation);
    /// A frame that shows `picture` is on the screen.
    void presented(const Picture* picture, double now_ms);

  private:
    struct Event {
        std::int64_t id;
        const char* kind;
        double time_ms;
        std::uint64_t generation = 0;  // 0: not applied yet
        double first_frame_ms = 0;     // 0: not taken up yet
    };
    static std::string start_of_row(const Event& event);

    std::ofstream file_;
    std::vector<Event> waiting_;
    std::int64_t count_ = 0;
};

}  // namespace kd
