#include "app/engine/source.h"

#include "app/frame/gl_frame.h"
#include "renderer/cpu/cpu_tracer.h"
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

/// Cuts frames into tiles small enough to stop between.
class GlSource final : public FrameSource {
  public:
    GlSource(Context& context, std::function<void(int)> compiling)
        : tracer_(context), software_(context.is_software()) {
        tracer_.tell_compiling(std::move(compiling));
    }

    void prepare(const FrameTask& task, int width, int height) override {
        if (task.world != world_) {
            tracer_.upload(task.world->scene(), task.world->tree);
            world_ = task.world;
            drawer_.forget_speed();
        }
        tracer_.prepare(complete(task), width, height);
    }

    FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                    const std::function<void(float)>& progress) override {
        prepare(task, frame.width, frame.height);
        return drawer_.draw(tracer_, complete(task), task.camera, frame.width, frame.height, stop, progress);
    }

    void wake(const FrameTask& task, const Frame& frame, const std::stop_token& stop) override {
        if (!software_) drawer_.wake(tracer_, complete(task), task.camera, frame.width, frame.height, stop);
    }

    void read(const FrameTask& task, Frame& frame) override { frame = tracer_.read_frame(task.config); }
    [[nodiscard]] std::string clock() const override { return drawer_.clock(); }

  private:
    static constexpr double tile_ms = 10;

    /// What is not counted for the maps is timed, and counts no shaded pixels either.
    static GlTraceConfig complete(const FrameTask& task) {
        return {.trace = task.config, .early_z = task.early_z, .count_shaded = task.config.counters};
    }

    std::shared_ptr<const World> world_;  // before the tracer that reads it
    GlTracer tracer_;
    bool software_;
    GlFrameDrawer drawer_{tile_ms};
};

}  // namespace

std::unique_ptr<FrameSource> make_cpu_source() { return std::make_unique<CpuSource>(); }

std::unique_ptr<FrameSource> make_gl_source(Context& context, std::function<void(int)> compiling) {
    return std::make_unique<GlSource>(context, std::move(compiling));
}

}  // namespace kd
