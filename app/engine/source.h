// The machines that trace frames for the engine. One thread uses a source from its first call to its end.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "app/engine/world.h"
#include "app/frame/frame_time.h"
#include "renderer/cpu/cpu_mode.h"
#include "renderer/gl/context.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// What is traced, on how many threads (0 = all; for the CPU alone), and how pixels are culled (for the GPU alone).
struct FrameTask {
    std::shared_ptr<const World> world;
    TraceConfig config;
    PinholeCamera camera;
    int threads = 0;
    EarlyZ early_z = EarlyZ::working;
};

class FrameSource {
  public:
    virtual ~FrameSource() = default;

    /// Makes tables, programs and targets, outside of any timing. False where `stop` ended it before. InputError where
    /// the source has to refuse.
    virtual bool prepare(const FrameTask& task, int width, int height, const std::stop_token& stop) = 0;
    /// Before a frame that is timed: see GlFrameDrawer::wake().
    virtual void wake(const FrameTask&, const Frame&, const std::stop_token&) {}
    /// Traces a width x height frame, as far as `stop` lets it; keeps it to itself. `frame` may serve as its memory.
    virtual FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                            const std::function<void(float)>& progress) = 0;
    /// The same of some tiles of the frame traced last; the others stay as they were.
    virtual FrameTime trace_tiles(const FrameTask& task, Frame& frame, std::span<const Tile> tiles,
                                  const std::stop_token& stop) = 0;
    /// Brings what trace() made into `frame`.
    virtual void read(const FrameTask& task, Frame& frame) = 0;
    [[nodiscard]] virtual std::string clock() const = 0;
    /// Of the task prepared last: its upload, and its programs when they were made, which may be several tasks ago.
    [[nodiscard]] virtual SetupTimes setup() const { return {}; }
};

[[nodiscard]] std::unique_ptr<FrameSource> make_cpu_source(CpuMode mode);
/// `context` is current and outlives the source; `compiling` as in GlTracer::tell_compiling().
[[nodiscard]] std::unique_ptr<FrameSource> make_gl_source(Context& context, GlMode mode,
                                                          std::function<void(int)> compiling);

}  // namespace kd
