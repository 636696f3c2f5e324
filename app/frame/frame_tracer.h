// Whole frames by any tracer, one after another, timed: what pictures and benchmarks are made with.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "app/frame/frame_time.h"
#include "app/session.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/kdtree/tree.h"
#include "renderer/trace/frame.h"

namespace kd {

class FrameTracer {
  public:
    virtual ~FrameTracer() = default;

    /// Another scene and tree, which must outlive their use.
    virtual void load(const FlatScene& scene, const KdTree& tree) = 0;

    /// Makes tables, programs and targets, outside of any timing. InputError where the tracer has to refuse.
    virtual void prepare(const TraceConfig& config, int width, int height) = 0;

    /// Traces one frame and keeps it. With `progress` the work is cut into bands, between which it can be stopped.
    virtual FrameTime trace(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                            std::stop_token stop = {}, const std::function<void(float)>& progress = {}) = 0;

    /// The same of some tiles only; the others stay as they were.
    virtual FrameTime trace_tiles(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                                  std::span<const Tile> tiles, std::stop_token stop = {},
                                  const std::function<void(float)>& progress = {}) = 0;

    /// The frame traced last.
    [[nodiscard]] virtual Frame frame(const TraceConfig& config) = 0;

    [[nodiscard]] virtual std::string renderer() const = 0;          // what it runs on
    [[nodiscard]] virtual std::string clock() const = 0;             // what its times are read from
    [[nodiscard]] virtual std::string driver() const { return {}; }  // GL_VERSION
    [[nodiscard]] virtual SetupTimes setup() const { return {}; }
    [[nodiscard]] virtual bool software_gl() const { return false; }
};

/// What only the GL tracer asks.
struct GlChoices {
    ContextKind context = ContextKind::automatic;
    EarlyZ early_z = EarlyZ::working;
    bool count_shaded = false;
    bool wake = true;  // a GPU that has idled, before a frame is timed (GlFrameDrawer::wake())
};

/// `scene` and `tree` must outlive the tracer. `gl` and `threads` matter to GL and to the CPU alone. ContextError.
[[nodiscard]] std::unique_ptr<FrameTracer> make_frame_tracer(TracerKind kind, const FlatScene& scene,
                                                             const KdTree& tree, int threads, const GlChoices& gl);

}  // namespace kd
