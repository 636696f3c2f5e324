#include "app/engine_source.h"

#include <algorithm>
#include <chrono>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

class CpuSource final : public FrameSource {
  public:
    void prepare(const FrameTask& task, int, int) override {
        if (task.world != world_) {
            tracer_ = std::make_unique<CpuTracer>(task.world->scene(), task.world->tree);
            world_ = task.world;
        }
        tracer_->prepare(task.config);
    }

    FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                    const std::function<void(float)>& progress) override {
        prepare(task, frame.width, frame.height);
        FrameTime time;
        time.total_ms = wall_ms([&] {
            time.complete = tracer_->trace_frame(task.config, task.camera, frame, task.threads, stop, progress);
        });
        return time;
    }

    void read(const FrameTask&, Frame&) override {}  // trace() wrote it there
    [[nodiscard]] std::string clock() const override { return "steady clock"; }

  private:
    std::shared_ptr<const World> world_;  // before the tracer that reads it
    std::unique_ptr<CpuTracer> tracer_;
};

/// Cuts frames into bands small enough to stop between, larger where the machine is fast.
class GlSource final : public FrameSource {
  public:
    explicit GlSource(Context& context) : tracer_(context) {}

    void prepare(const FrameTask& task, int width, int height) override {
        if (task.world != world_) {
            tracer_.upload(task.world->scene(), task.world->tree);
            world_ = task.world;
        }
        tracer_.prepare(complete(task), width, height);
    }

    FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                    const std::function<void(float)>& progress) override {
        prepare(task, frame.width, frame.height);
        FrameTime time;
        for (int y = 0; y < frame.height;) {
            if (stop.stop_requested()) {
                time.complete = false;
                return time;
            }
            const Tile band{0, y, frame.width, std::min(y + rows_, frame.height)};
            const GlFrameReport report = tracer_.draw(complete(task), task.camera, frame.width, frame.height, band);
            add(report, time);
            adapt(report.total_ms / double(band.y1 - band.y0));
            y = band.y1;
            if (progress) progress(float(y) / float(frame.height));
        }
        return time;
    }

    void read(const FrameTask& task, Frame& frame) override { frame = tracer_.read_frame(task.config); }
    [[nodiscard]] std::string clock() const override { return clock_; }

  private:
    static constexpr double band_ms = 10;

    /// What is not counted for the maps is timed, and counts no shaded pixels either.
    static GlTraceConfig complete(const FrameTask& task) {
        return {.trace = task.config, .early_z = task.early_z, .count_shaded = task.config.counters};
    }

    void add(const GlFrameReport& report, FrameTime& time) {
        clock_ = report.clock;
        time.total_ms += report.total_ms;
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            if (report.pass_ms[pass] > 0) time.pass_ms[pass] = std::max(time.pass_ms[pass], 0.0) + report.pass_ms[pass];
            std::int64_t& shaded = time.shaded_pixels[pass];
            if (report.shaded_pixels[pass] >= 0)
                shaded = std::max(shaded, std::int64_t(0)) + report.shaded_pixels[pass];
        }
    }

    /// Rows per band for about `band_ms`, in steps of at most four so that one odd band does not decide.
    void adapt(double ms_per_row) {
        const double wanted = ms_per_row > 0 ? band_ms / ms_per_row : 1e9;
        rows_ = int(std::clamp(wanted, std::max(1.0, rows_ / 4.0), std::min(16384.0, rows_ * 4.0)));
    }

    std::shared_ptr<const World> world_;  // before the tracer that reads it
    GlTracer tracer_;
    int rows_ = 16;
    std::string clock_ = "not read yet";
};

}  // namespace

std::unique_ptr<FrameSource> make_cpu_source() { return std::make_unique<CpuSource>(); }

std::unique_ptr<FrameSource> make_gl_source(Context& context) { return std::make_unique<GlSource>(context); }

}  // namespace kd
