#include "app/engine/source.h"

#include <algorithm>
#include <vector>

#include "app/frame/gl_frame.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

class CpuSource final : public FrameSource {
  public:
    explicit CpuSource(CpuMode mode) : mode_(mode) {}

    bool prepare(const FrameTask& task, int, int, const std::stop_token& stop) override {
        if (task.world != world_) {
            tracer_ = std::make_unique<CpuTracer>(task.world->scene(), task.world->tree, mode_);
            world_ = task.world;
        }
        return tracer_->prepare(task.config, task.threads, stop);
    }

    FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                    const std::function<void(float)>& progress) override {
        FrameTime time;
        time.complete = prepare(task, frame.width, frame.height, stop);
        if (!time.complete) return time;
        time.total_ms = wall_ms([&] {
            time.complete = tracer_->trace_frame(task.config, task.camera, frame, task.threads, stop, progress);
        });
        return time;
    }

    FrameTime trace_tiles(const FrameTask& task, Frame& frame, std::span<const Tile> tiles,
                          const std::stop_token& stop) override {
        FrameTime time;
        time.complete = prepare(task, frame.width, frame.height, stop);
        if (!time.complete) return time;
        time.total_ms = wall_ms([&] {
            time.complete = tracer_->trace_tiles(task.config, task.camera, tiles, frame, task.threads, stop, {});
        });
        return time;
    }

    void read(const FrameTask&, Frame&) override {}  // trace() wrote it there
    [[nodiscard]] std::string clock() const override { return "steady clock"; }

  private:
    CpuMode mode_;
    std::shared_ptr<const World> world_;  // before the tracer that reads it
    std::unique_ptr<CpuTracer> tracer_;
};

/// Cuts frames into tiles small enough to stop between.
class GlSource final : public FrameSource {
  public:
    GlSource(Context& context, GlMode mode, std::function<void(int)> compiling)
        : context_(context), tracer_(context, mode) {
        tracer_.tell_compiling([this, told = std::move(compiling)](int programs) {
            compiled_now_ = compiled_now_ || programs > 0;
            if (told) told(programs);
        });
    }

    bool prepare(const FrameTask& task, int width, int height, const std::stop_token&) override {
        if (task.world != world_) {
            setup_.upload_ms = wall_ms([&] {
                tracer_.upload(task.world->scene(), task.world->tree);
                context_.gl().Finish();
            });
            if (!world_ || !alike(*world_, *task.world)) drawer_.forget_speed();
            world_ = task.world;
        }
        compiled_now_ = false;
        const GlTraceConfig config = complete(task);
        const double ms = wall_ms([&] { tracer_.prepare(config, width, height); });
        note_compiled(config, ms);
        return true;
    }

    FrameTime trace(const FrameTask& task, Frame& frame, const std::stop_token& stop,
                    const std::function<void(float)>& progress) override {
        prepare(task, frame.width, frame.height, stop);
        return drawer_.draw(tracer_, complete(task), task.camera, frame.width, frame.height, stop, progress);
    }

    FrameTime trace_tiles(const FrameTask& task, Frame& frame, std::span<const Tile> tiles,
                          const std::stop_token& stop) override {
        prepare(task, frame.width, frame.height, stop);
        return drawer_.draw_tiles(tracer_, complete(task), task.camera, frame.width, frame.height, tiles, stop, {});
    }

    void wake(const FrameTask& task, const Frame& frame, const std::stop_token& stop) override {
        if (!context_.is_software())
            drawer_.wake(tracer_, complete(task), task.camera, frame.width, frame.height, stop);
    }

    void read(const FrameTask& task, Frame& frame) override { frame = tracer_.read_frame(task.config); }
    [[nodiscard]] std::string clock() const override { return drawer_.clock(); }
    [[nodiscard]] SetupTimes setup() const override { return setup_; }

  private:
    static constexpr double tile_ms = 10;
    static constexpr std::size_t most_compiled = 16;

    /// Programs stay: a configuration prepared again costs nothing, and its time is that of when it was new.
    void note_compiled(GlTraceConfig config, double ms) {
        config.trace = at_first_sample(config.trace);
        auto known = std::ranges::find(compiled_, config, &Compiled::config);
        if (known == compiled_.end()) {
            if (compiled_.size() == most_compiled) compiled_.erase(compiled_.begin());
            known = compiled_.insert(compiled_.end(), {config, ms});
        } else if (compiled_now_) {
            known->ms = ms;
        }
        setup_.compile_ms = known->ms;
    }

    /// What is not counted for the maps is timed, and counts no shaded pixels either.
    static GlTraceConfig complete(const FrameTask& task) {
        return {.trace = task.config, .early_z = task.early_z, .count_shaded = task.config.counters};
    }

    struct Compiled {
        GlTraceConfig config;
        double ms = 0;  // of the prepare() that made its programs
    };

    std::shared_ptr<const World> world_;  // before the tracer that reads it
    Context& context_;
    GlTracer tracer_;
    GlFrameDrawer drawer_{tile_ms};
    std::vector<Compiled> compiled_;
    bool compiled_now_ = false;  // in the prepare() that runs
    SetupTimes setup_;
};

}  // namespace

std::unique_ptr<FrameSource> make_cpu_source(CpuMode mode) { return std::make_unique<CpuSource>(mode); }

std::unique_ptr<FrameSource> make_gl_source(Context& context, GlMode mode, std::function<void(int)> compiling) {
    return std::make_unique<GlSource>(context, mode, std::move(compiling));
}

}  // namespace kd
