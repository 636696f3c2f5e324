// The tracing thread's work: pictures from coarse to fine, and the rounds of CPU against GPU.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/engine/duel.h"
#include "app/engine/frame_pool.h"
#include "app/engine/levels.h"
#include "app/engine/source.h"
#include "app/engine/state.h"
#include "renderer/measure/needs_costs.h"

namespace kd {

/// Opens a GL context and makes it current on the calling thread. ContextError where there is none.
using OpenGl = std::function<std::unique_ptr<Context>()>;

struct TraceRequest {
    std::shared_ptr<const World> world;
    TraceConfig config;
    TracerKind tracer = TracerKind::cpu;
    Camera camera;
    int width = 0, height = 0;
    int threads = 0;
    EarlyZ early_z = EarlyZ::working;
    std::uint64_t generation = 0;
    SamplePlan samples{0, 0};  // of light; 0: it is not sampled
    int duel_scale = 0;        // of the frames that a duel times; 0 = the program's choice
    bool moving = false;       // another pose follows at once: one frame, as fine as time allows
};

/// A frame's colours and its time in ms.
struct SampleReply {
    Image<Vec4> colour;
    double ms = 0;
};

/// Used by one thread alone, from open() to its destruction: the GL context belongs to that thread.
class Tracing {
  public:
    /// `compiling` as in GlTracer::tell_compiling(), on the tracing thread.
    explicit Tracing(OpenGl open_gl, std::function<void(int)> compiling = {})
        : open_gl_(std::move(open_gl)), compiling_(std::move(compiling)) {}

    /// Opens GL where there is some, once, and tests it.
    const GlStatus& open();

    /// Frames of the request, coarse to fine, each handed to `publish`; ends early where stopped. InputError, GlError
    /// and ContextError where the tracer cannot do it.
    void trace(const TraceRequest& request, const std::stop_token& stop,
               const std::function<void(TracedFrame)>& publish, const std::function<void(float)>& progress);

    /// A frame of the request through a camera that is off by `offset` pixels, without counters. Nothing where stopped.
    std::optional<SampleReply> sample(const TraceRequest& request, glm::dvec2 offset, const std::stop_token& stop);

    /// One frame by each machine, without counters. Nothing where stopped.
    std::optional<DuelReply> duel(const TraceRequest& request, const std::stop_token& stop);

    /// What each feature saves that the request leaves out, at the duel's size. Nothing where stopped.
    std::vector<FeatureTime> time_needs(const TraceRequest& request, int rounds, const std::stop_token& stop,
                                        const std::function<void(float)>& progress);

  private:
    FrameSource& source(TracerKind kind);
    void trace_levels(const TraceRequest& request, const std::stop_token& stop,
                      const std::function<void(TracedFrame)>& publish, const std::function<void(float)>& progress);
    void add_samples(const TraceRequest& request, TracedFrame shown, const std::stop_token& stop,
                     const std::function<void(TracedFrame)>& publish, const std::function<void(float)>& progress);
    std::optional<DuelReply> duel_round(const TraceRequest& request, const std::stop_token& stop);
    void replace_context(const ContextLost& lost);
    void forget_speed_of_others(const TraceRequest& request);
    int scale_to_time(const TraceRequest& request);

    OpenGl open_gl_;
    std::function<void(int)> compiling_;
    GlStatus status_;
    std::optional<std::chrono::steady_clock::time_point> lost_at_;  // when a context was lost last
    std::unique_ptr<Context> context_;                              // before the source that lives in it
    std::array<std::unique_ptr<FrameSource>, 3> cpu_, gl_;          // by CpuMode and GlMode, made when first asked for
    FramePool frames_;
    LevelPlan plan_;
    TraceRequest planned_for_;
    std::int64_t rays_ = 0;  // of the frame that the next two say
    std::uint64_t counted_generation_ = 0;
    int counted_width_ = 0;
    int duel_scale_ = 0;  // the program's choice, for this scene and size of the picture
    std::weak_ptr<const LoadedScene> duel_scene_;
    int duel_rounds_ = 0;  // their number says who begins the next
    int duel_width_ = 0, duel_height_ = 0;
};

}  // namespace kd
