#include "app/cli/progress_line.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <utility>

#include "renderer/io/printable.h"

namespace kd {

namespace {
constexpr int bar_width = 30;
constexpr const char* wiped = "\r\x1b[K";
}  // namespace

void tell_work(const CommandContext& context, const std::string& what) {
    if (!context.progress) context.err << fmt::format("kdscope: {}\n", printable(what)) << std::flush;
}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::wipe() {
    const std::lock_guard lock(mutex_);
    if (std::exchange(drawn_, false)) err_ << wiped << std::flush;
}

void ProgressLine::show(float fraction, const std::string& what) {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;
    const int filled = std::clamp(int(fraction * float(bar_width)), 0, bar_width);
    err_ << wiped
         << fmt::format("[{:=<{}}{:<{}}] {:3.0f} %  {}", "", filled, "", bar_width - filled, 100 * fraction,
                        printable(what))
         << std::flush;
}

}  // namespace kd
