#include "app/frame/counted_frame.h"

#include <fmt/format.h>

#include "viz/unfinished.h"

namespace kd {

std::optional<Frame> trace_counted(FrameTracer& tracer, TraceConfig config, const PinholeCamera& camera, int width,
                                   int height, const std::stop_token& stop) {
    config.counters = true;
    tracer.prepare(config, width, height);
    if (!tracer.trace(config, camera, width, height, stop).complete || stop.stop_requested()) return std::nullopt;
    return tracer.frame(config);
}

void note_unfinished(const Frame& frame, const std::string& name, std::vector<std::string>& notes) {
    if (const UnfinishedPixels unfinished = count_unfinished(frame); unfinished.pixels > 0)
        notes.push_back(fmt::format("{}: {}", name, unfinished_text(unfinished)));
}

}  // namespace kd
