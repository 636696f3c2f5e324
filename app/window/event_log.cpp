#include "app/window/event_log.h"

#include <chrono>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"

namespace kd {

double system_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string EventLog::start_of_row(const Event& e) {
    const std::string first = e.first_frame_ms > 0 ? fmt::format("{:.2f}", e.first_frame_ms) : "";
    return fmt::format("{},{},{:.2f},{}", e.id, e.kind, e.time_ms, first);
}

EventLog::EventLog(const std::string& path) {
    if (path.empty()) return;
    file_.open(path);
    if (!file_) throw InputError("KDSCOPE_EVENT_LOG: cannot write '" + path + "'; name a file in a folder that exists");
    file_ << "event,kind,t_event_ms,t_first_frame_ms,t_frame_ms,latency_ms\n";
}

EventLog::~EventLog() {
    for (const Event& e : waiting_) file_ << start_of_row(e) << ",,\n";
}

void EventLog::input(const char* kind, double now_ms) {
    if (file_.is_open()) waiting_.push_back({++count_, kind, now_ms});
}

void EventLog::applied(std::uint64_t generation) {
    for (Event& event : waiting_)
        if (event.generation == 0) event.generation = generation;
}

void EventLog::presented(const Picture* picture, double now_ms) {
    const std::uint64_t shown = picture ? picture->generation : 0;
    std::erase_if(waiting_, [&](Event& e) {
        if (e.generation == 0) return false;
        if (e.first_frame_ms == 0) e.first_frame_ms = now_ms;
        if (e.generation > shown) return false;
        file_ << start_of_row(e) << fmt::format(",{:.2f},{:.2f}\n", now_ms, now_ms - e.time_ms);
        return true;
    });
    if (file_.is_open()) file_.flush();
}

}  // namespace kd
