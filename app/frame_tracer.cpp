#include "app/frame_tracer.h"

#include <algorithm>
#include <optional>

#include "app/machine_info.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

class CpuFrameTracer final : public FrameTracer {
  public:
    CpuFrameTracer(const FlatScene& scene, const KdTree& tree, int threads) : tracer_(scene, tree), threads_(threads) {}

    void prepare(const TraceConfig& config, int width, int height) override {
        tracer_.prepare(config);
        if (frame_.width != width || frame_.height != height) frame_ = Frame(width, height);
    }

    FrameTime trace(const TraceConfig& config, const PinholeCamera& camera, int width, int height, std::stop_token stop,
                    const std::function<void(float)>& progress) override {
        prepare(config, width, height);
        FrameTime time;
        time.total_ms =
            wall_ms([&] { time.complete = tracer_.trace_frame(config, camera, frame_, threads_, stop, progress); });
        return time;
    }

    [[nodiscard]] Frame frame(const TraceConfig&) override { return frame_; }
    [[nodiscard]] std::string renderer() const override { return cpu_renderer(threads_); }
    [[nodiscard]] std::string clock() const override { return "steady clock"; }

  private:
    CpuTracer tracer_;
    Frame frame_;
    int threads_;
};

class GlFrameTracer final : public FrameTracer {
  public:
    GlFrameTracer(const FlatScene& scene, const KdTree& tree, const GlChoices& choices)
        : choices_(choices), context_(Context::create(choices.context)),
          tracer_(std::make_unique<GlTracer>(*context_)) {
        tracer_->upload(scene, tree);
    }
    ~GlFrameTracer() override { context_->make_current(); }
    GlFrameTracer(const GlFrameTracer&) = delete;
    GlFrameTracer& operator=(const GlFrameTracer&) = delete;

    void prepare(const TraceConfig& config, int width, int height) override {
        context_->make_current();
        tracer_->prepare(complete(config), width, height);
    }

    FrameTime trace(const TraceConfig& config, const PinholeCamera& camera, int width, int height, std::stop_token stop,
                    const std::function<void(float)>& progress) override {
        context_->make_current();
        warm_up(config, camera, width, height);
        const int rows = progress ? std::max(1, pixels_per_band / width) : height;
        FrameTime time;
        for (int y = 0; y < height; y += rows) {
            if (stop.stop_requested()) {
                time.complete = false;
                break;
            }
            const Tile band{0, y, width, std::min(y + rows, height)};
            const GlFrameReport report = tracer_->draw(complete(config), camera, width, height, band);
            clock_ = report.clock;
            time.total_ms += report.total_ms;
            for (std::size_t pass = 0; pass < pass_count; ++pass) {
                if (report.pass_ms[pass] > 0)
                    time.pass_ms[pass] = std::max(time.pass_ms[pass], 0.0) + report.pass_ms[pass];
                if (report.shaded_pixels[pass] >= 0)
                    time.shaded_pixels[pass] =
                        std::max(time.shaded_pixels[pass], std::int64_t(0)) + report.shaded_pixels[pass];
            }
            if (progress) progress(float(band.y1) / float(height));
        }
        return time;
    }

    [[nodiscard]] Frame frame(const TraceConfig& config) override {
        context_->make_current();
        return tracer_->read_frame(config);
    }
    [[nodiscard]] std::string renderer() const override { return context_->renderer(); }
    [[nodiscard]] std::string clock() const override { return clock_; }
    [[nodiscard]] bool software_gl() const override { return context_->is_software(); }

  private:
    static constexpr int pixels_per_band = 32768;

    [[nodiscard]] GlTraceConfig complete(const TraceConfig& config) const {
        return {.trace = config, .early_z = choices_.early_z, .count_shaded = choices_.count_shaded};
    }

    /// Drivers finish compiling at the first draw, so one of a few pixels comes before the timing.
    void warm_up(const TraceConfig& config, const PinholeCamera& camera, int width, int height) {
        if (warm_ == config) return;
        const Tile middle{width / 2, height / 2, std::min(width / 2 + 4, width), std::min(height / 2 + 4, height)};
        tracer_->draw(complete(config), camera, width, height, middle);
        warm_ = config;
    }

    GlChoices choices_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<GlTracer> tracer_;
    std::string clock_ = "not read";
    std::optional<TraceConfig> warm_;
};

}  // namespace

std::unique_ptr<FrameTracer> make_frame_tracer(TracerKind kind, const FlatScene& scene, const KdTree& tree, int threads,
                                               const GlChoices& gl) {
    if (kind == TracerKind::cpu) return std::make_unique<CpuFrameTracer>(scene, tree, threads);
    return std::make_unique<GlFrameTracer>(scene, tree, gl);
}

}  // namespace kd
