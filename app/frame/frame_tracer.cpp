#include "app/frame/frame_tracer.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "app/frame/gl_frame.h"
#include "app/report/machine_info.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

class CpuFrameTracer final : public FrameTracer {
  public:
    CpuFrameTracer(const FlatScene& scene, const KdTree& tree, CpuMode mode, int threads)
        : mode_(mode), threads_(threads) {
        load(scene, tree);
    }

    void load(const FlatScene& scene, const KdTree& tree) final { tracer_.emplace(scene, tree, mode_); }

    void prepare(const TraceConfig& config, int width, int height) override {
        (void)make_ready(config, width, height, {});
    }

    FrameTime trace(const TraceConfig& config, const PinholeCamera& camera, int width, int height, std::stop_token stop,
                    const std::function<void(float)>& progress) override {
        FrameTime time;
        time.complete = make_ready(config, width, height, stop);
        if (!time.complete) return time;
        time.total_ms =
            wall_ms([&] { time.complete = tracer_->trace_frame(config, camera, frame_, threads_, stop, progress); });
        return time;
    }

    FrameTime trace_tiles(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                          std::span<const Tile> tiles, std::stop_token stop,
                          const std::function<void(float)>& progress) override {
        FrameTime time;
        time.complete = make_ready(config, width, height, stop);
        if (!time.complete) return time;
        time.total_ms = wall_ms(
            [&] { time.complete = tracer_->trace_tiles(config, camera, tiles, frame_, threads_, stop, progress); });
        return time;
    }

    [[nodiscard]] Frame frame(const TraceConfig&) override { return frame_; }
    [[nodiscard]] std::string renderer() const override { return cpu_renderer(threads_); }
    [[nodiscard]] std::string clock() const override { return "steady clock"; }
    [[nodiscard]] SetupTimes setup() const override { return {.tables_ms = tables_ms_}; }

  private:
    /// False where stopped before the end.
    bool make_ready(const TraceConfig& config, int width, int height, const std::stop_token& stop) {
        if (frame_.width != width || frame_.height != height) frame_ = Frame(width, height);
        bool made = false;
        tables_ms_ += wall_ms([&] { made = tracer_->prepare(config, threads_, stop); });
        return made;
    }

    std::optional<CpuTracer> tracer_;
    Frame frame_;
    CpuMode mode_;
    int threads_;
    double tables_ms_ = 0;
};

class GlFrameTracer final : public FrameTracer {
  public:
    GlFrameTracer(const FlatScene& scene, const KdTree& tree, GlMode mode, const GlChoices& choices)
        : choices_(choices), context_(Context::create(choices.context)),
          tracer_(std::make_unique<GlTracer>(*context_, mode)) {
        load(scene, tree);
    }
    ~GlFrameTracer() override { context_->make_current(); }
    GlFrameTracer(const GlFrameTracer&) = delete;
    GlFrameTracer& operator=(const GlFrameTracer&) = delete;

    void load(const FlatScene& scene, const KdTree& tree) final {
        context_->make_current();
        setup_.upload_ms = wall_ms([&] {
            tracer_->upload(scene, tree);
            context_->gl().Finish();
        });
    }

    void prepare(const TraceConfig& config, int width, int height) override {
        context_->make_current();
        const double ms = wall_ms([&] { tracer_->prepare(complete(config), width, height); });
        const TraceConfig first = at_first_sample(config);
        if (prepared_ == first) return;
        prepared_ = first;
        setup_.compile_ms = ms;
    }

    FrameTime trace(const TraceConfig& config, const PinholeCamera& camera, int width, int height, std::stop_token stop,
                    const std::function<void(float)>& progress) override {
        context_->make_current();
        warm_up(config, camera, width, height);
        // Later samples come at once.
        if (choices_.wake && config.sampling.sample <= 0 && !context_->is_software())
            drawer_.wake(*tracer_, complete(config), camera, width, height, stop);
        return drawer_.draw(*tracer_, complete(config), camera, width, height, stop, progress);
    }

    FrameTime trace_tiles(const TraceConfig& config, const PinholeCamera& camera, int width, int height,
                          std::span<const Tile> tiles, std::stop_token stop,
                          const std::function<void(float)>& progress) override {
        context_->make_current();
        warm_up(config, camera, width, height);
        return drawer_.draw_tiles(*tracer_, complete(config), camera, width, height, tiles, stop, progress);
    }

    [[nodiscard]] Frame frame(const TraceConfig& config) override {
        context_->make_current();
        return tracer_->read_frame(config);
    }
    [[nodiscard]] std::string renderer() const override { return context_->renderer(); }
    [[nodiscard]] std::string clock() const override { return drawer_.clock(); }
    [[nodiscard]] std::string driver() const override { return context_->version(); }
    [[nodiscard]] SetupTimes setup() const override { return setup_; }
    [[nodiscard]] bool software_gl() const override { return context_->is_software(); }

  private:
    static constexpr double tile_ms = 100;  // drivers give up on draws that take seconds

    [[nodiscard]] GlTraceConfig complete(const TraceConfig& config) const {
        return {.trace = config, .early_z = choices_.early_z, .count_shaded = choices_.count_shaded};
    }

    /// Drivers finish compiling at the first draw, so one of a few pixels comes before the timing.
    void warm_up(const TraceConfig& config, const PinholeCamera& camera, int width, int height) {
        const TraceConfig first = at_first_sample(config);
        if (std::ranges::find(warm_, first) != warm_.end()) return;
        const Tile middle{width / 2, height / 2, std::min(width / 2 + 4, width), std::min(height / 2 + 4, height)};
        const double ms = wall_ms([&] { tracer_->draw(complete(config), camera, width, height, middle); });
        if (prepared_ == first) setup_.compile_ms += ms;
        warm_.push_back(first);
    }

    GlChoices choices_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<GlTracer> tracer_;
    GlFrameDrawer drawer_{tile_ms};
    std::optional<TraceConfig> prepared_;
    std::vector<TraceConfig> warm_;
    SetupTimes setup_;
};

}  // namespace

std::unique_ptr<FrameTracer> make_frame_tracer(TracerKind kind, const FlatScene& scene, const KdTree& tree, int threads,
                                               const GlChoices& gl) {
    if (runs_on_cpu(kind)) return std::make_unique<CpuFrameTracer>(scene, tree, cpu_mode(kind), threads);
    return std::make_unique<GlFrameTracer>(scene, tree, gl_mode(kind), gl);
}

}  // namespace kd
