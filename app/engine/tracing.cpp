#include "app/engine/tracing.h"

#include <numeric>
#include <utility>

#include "renderer/geometry/input_error.h"
#include "renderer/measure/error_time/sampling.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

FrameTask task_of(const TraceRequest& request) {
    return {request.world, request.config, pinhole(request.camera, request.width, request.height), request.threads,
            request.early_z};
}

}  // namespace

const GlStatus& Tracing::open() {
    if (status_.known) return status_;
    status_.known = true;
    try {
        if (!open_gl_) throw ContextError("switched off");
        context_ = open_gl_();
        status_.renderer = context_->renderer();
        status_.version = context_->version();
        status_.software = context_->is_software();
        gl_.front() = make_gl_source(*context_, GlMode::fragment, compiling_);
    } catch (const std::exception& error) {
        status_.unavailable = error.what();
        status_.fails = dynamic_cast<const GlError*>(&error) != nullptr;
        context_.reset();
    }
    return status_;
}

/// Everything that was in it goes with it. A GPU that is reset again at once is not asked a third time.
void Tracing::replace_context(const ContextLost& lost) {
    constexpr std::chrono::seconds too_soon(10);
    for (auto& machine : gl_) machine.reset();
    context_.reset();
    const auto now = std::chrono::steady_clock::now();
    const bool again = lost_at_ && now - *lost_at_ < too_soon;
    lost_at_ = now;
    const int losses = status_.losses + 1;
    status_ = GlStatus{};
    status_.losses = losses;
    if (!again) {
        (void)open();
        return;
    }
    status_.known = status_.fails = true;
    status_.unavailable = std::string(lost.what()) + ", twice within 10 s";
    throw ContextError(status_.unavailable);
}

FrameSource& Tracing::source(TracerKind kind) {
    if (runs_on_cpu(kind)) {
        auto& machine = cpu_.at(std::size_t(cpu_mode(kind)));
        if (!machine) machine = make_cpu_source(cpu_mode(kind));
        return *machine;
    }
    if (!open().available())
        throw ContextError((status_.fails ? "" : "GPU tracing needs OpenGL 4.3: ") + status_.unavailable);
    auto& machine = gl_.at(std::size_t(gl_mode(kind)));
    if (!machine) machine = make_gl_source(*context_, gl_mode(kind), compiling_);
    return *machine;
}

void Tracing::forget_speed_of_others(const TraceRequest& request) {
    const bool same = planned_for_.world && alike(*planned_for_.world, *request.world) &&
                      planned_for_.config == request.config && planned_for_.tracer == request.tracer &&
                      planned_for_.threads == request.threads && planned_for_.early_z == request.early_z;
    if (!same) plan_.reset();
    planned_for_ = request;
}

void Tracing::trace(const TraceRequest& request, const std::stop_token& stop,
                    const std::function<void(TracedFrame)>& publish, const std::function<void(float)>& progress) {
    while (true) {
        try {
            return trace_levels(request, stop, publish, progress);
        } catch (const ContextLost& lost) {
            replace_context(lost);  // throws where it is of no use
        }
    }
}

std::optional<DuelReply> Tracing::duel(const TraceRequest& request, const std::stop_token& stop) {
    try {
        return duel_round(request, stop);
    } catch (const ContextLost& lost) {
        replace_context(lost);
        return std::nullopt;  // another round comes
    }
}

std::optional<SampleReply> Tracing::sample(const TraceRequest& request, glm::dvec2 offset,
                                           const std::stop_token& stop) {
    try {
        FrameTask task = task_of(request);
        task.config.counters = false;
        task.camera = shifted(task.camera, offset, request.width, request.height);
        FrameSource& machine = source(request.tracer);
        const std::shared_ptr<Frame> scratch = frames_.take(request.width, request.height);
        if (!machine.prepare(task, request.width, request.height, stop)) return std::nullopt;
        const FrameTime time = machine.trace(task, *scratch, stop, {});
        if (!time.complete) return std::nullopt;
        machine.read(task, *scratch);
        return SampleReply{scratch->colour, time.total_ms};
    } catch (const ContextLost& lost) {
        replace_context(lost);
        return std::nullopt;  // another comes
    }
}

void Tracing::trace_levels(const TraceRequest& request, const std::stop_token& stop,
                           const std::function<void(TracedFrame)>& publish,
                           const std::function<void(float)>& progress) {
    forget_speed_of_others(request);
    FrameSource& machine = source(request.tracer);
    const FrameTask task = task_of(request);
    const SceneNeeds needs = scene_needs(request.world->facts, request.config);
    const std::vector<std::string> omitted =
        left_out(request.world->facts, request.config, runs_on_cpu(request.tracer));

    const int first =
        request.moving ? plan_.moving(request.width, request.height) : plan_.first(request.width, request.height);
    StepInterval upload{steady_seconds(), {}};
    if (!machine.prepare(task, scaled_size(request.width, first), scaled_size(request.height, first), stop)) return;
    upload.end = steady_seconds();
    for (int scale = first; scale >= 1; scale = plan_.next(scale, request.width, request.height)) {
        const int width = scaled_size(request.width, scale);
        const int height = scaled_size(request.height, scale);
        const double predicted = plan_.predicted_ms(scale, request.width, request.height);
        const bool at_once = scale == first && predicted > 0 && predicted < 2 * LevelPlan::first_frame_ms;
        const std::shared_ptr<Frame> frame = frames_.take(width, height);
        if (!machine.prepare(task, width, height, stop)) return;
        FrameTime time;
        const double with_reading = wall_ms([&] {
            time = machine.trace(task, *frame, at_once ? std::stop_token{} : stop, progress);
            if (time.complete) machine.read(task, *frame);
        });
        if (!time.complete) return;
        plan_.learn(with_reading, width * height);
        const TracedFrame traced{request.world,
                                 frame,
                                 {},
                                 request.camera,
                                 task.camera,
                                 request.config,
                                 request.tracer,
                                 scale,
                                 time,
                                 machine.clock(),
                                 needs,
                                 omitted,
                                 request.generation,
                                 count_unfinished(*frame),
                                 scale == 1 ? walk_totals(*frame) : std::array<CounterTotals, pass_count>{},
                                 {},
                                 {},
                                 request.samples.samples > 0 ? std::optional(SampleCount{1, 1.0}) : std::nullopt,
                                 upload,
                                 {upload.end, steady_seconds()}};
        publish(traced);
        if (request.moving || stop.stop_requested()) return;
        if (scale == 1 && request.samples.samples > 1) add_samples(request, traced, stop, publish, progress);
        if (scale == 1) return;
    }
}

/// Goes on from the first sample of every pixel. What has been gathered is shown about four times a second.
void Tracing::add_samples(const TraceRequest& request, TracedFrame shown, const std::stop_token& stop,
                          const std::function<void(TracedFrame)>& publish, const std::function<void(float)>& progress) {
    constexpr std::chrono::milliseconds between_pictures(250);
    FrameSource& machine = source(request.tracer);
    FrameTask task = task_of(request);
    Accumulator gathered(request.width, request.height);
    gathered.add(*shown.frame, gathered.tiles());
    std::vector<Tile> active = gathered.tiles();
    const std::shared_ptr<Frame> sample = frames_.take(request.width, request.height);
    auto published = std::chrono::steady_clock::now();
    for (int number = 1; number < request.samples.samples && !active.empty(); ++number) {
        task.config.sampling.sample = number;
        const bool all = active.size() == gathered.tiles().size();
        const FrameTime time =
            all ? machine.trace(task, *sample, stop, {}) : machine.trace_tiles(task, *sample, active, stop);
        if (!time.complete) return;
        machine.read(task, *sample);
        gathered.add(*sample, active);
        active = gathered.active(request.samples.error);
        progress(float(number + 1) / float(request.samples.samples));
        const bool last = active.empty() || number + 1 == request.samples.samples;
        const auto now = std::chrono::steady_clock::now();
        if (!last && now - published < between_pictures) continue;
        published = now;
        shown.frame = std::make_shared<const Frame>(gathered.frame());
        shown.samples = count_samples(gathered, request.samples);
        shown.unfinished = count_unfinished(*shown.frame);
        shown.totals = walk_totals(*shown.frame);
        publish(shown);
    }
}

int Tracing::scale_to_time(const TraceRequest& request) {
    if (request.duel_scale > 0) return request.duel_scale;
    const auto& scene = request.world->loaded;
    if (duel_scene_.lock() != scene || duel_width_ != request.width || duel_height_ != request.height) duel_scale_ = 0;
    duel_scene_ = scene;
    duel_width_ = request.width;
    duel_height_ = request.height;
    duel_scale_ =
        duel_scale(duel_scale_, [&](int scale) { return plan_.predicted_ms(scale, request.width, request.height); });
    return duel_scale_;
}

std::vector<FeatureTime> Tracing::time_needs(const TraceRequest& request, int rounds, const std::stop_token& stop,
                                             const std::function<void(float)>& progress) {
    FrameSource& machine = source(request.tracer);
    const int scale = scale_to_time(request);
    const int width = scaled_size(request.width, scale);
    const int height = scaled_size(request.height, scale);
    const std::shared_ptr<Frame> scratch = frames_.take(width, height);
    FrameTask task = task_of(request);
    task.config.counters = false;
    const auto frame = [&](FeatureSet forced) {
        task.config.forced = forced;
        machine.prepare(task, width, height, stop);
        return machine.trace(task, *scratch, stop, {}).sample();
    };
    const auto go_on = [&](float done) {
        progress(done);
        return !stop.stop_requested();
    };
    const bool on_cpu = runs_on_cpu(request.tracer);
    const std::vector<Feature> all = timed_features(request.world->facts, request.config, on_cpu);
    std::vector<FeatureTime> times = time_features(all, frame, rounds, go_on);
    if (stop.stop_requested()) return {};
    return times;
}

std::optional<DuelReply> Tracing::duel_round(const TraceRequest& request, const std::stop_token& stop) {
    const int scale = scale_to_time(request);
    DuelReply reply;
    reply.scale = scale;
    reply.width = scaled_size(request.width, scale);
    reply.height = scaled_size(request.height, scale);
    FrameTask task = task_of(request);
    if (counted_generation_ != request.generation || counted_width_ != reply.width) {
        const RayCounts counts = count_rays(request.world->scene(), request.world->tree, task.config, task.camera,
                                            reply.width, reply.height, stop);
        if (stop.stop_requested()) return std::nullopt;
        rays_ = std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
        counted_generation_ = request.generation;
        counted_width_ = reply.width;
    }
    reply.rays = rays_;
    task.config.counters = false;

    const std::shared_ptr<Frame> scratch = frames_.take(reply.width, reply.height);
    const auto time = [&](FrameSource& machine) {
        machine.prepare(task, reply.width, reply.height, stop);
        machine.wake(task, *scratch, stop);
        return machine.trace(task, *scratch, stop, {});
    };
    const auto by_cpu = [&] {
        FrameSource& machine = source(TracerKind::cpu);
        const FrameTime cpu = time(machine);
        reply.round.cpu = cpu.sample();
        reply.cpu_clock = machine.clock();
        return cpu.complete;
    };
    const auto by_gl = [&] {
        if (!open().available()) return true;
        FrameSource& machine = source(TracerKind::gl_fragment);
        const FrameTime gl = time(machine);
        reply.round.gl = gl.sample();
        reply.gl_clock = machine.clock();
        reply.gl_setup = machine.setup();
        return gl.complete;
    };
    if (!take_turns(2, duel_rounds_, [&](std::size_t machine) { return machine == 0 ? by_cpu() : by_gl(); }))
        return std::nullopt;
    ++duel_rounds_;
    return reply;
}

}  // namespace kd
