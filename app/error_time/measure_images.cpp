// P1 of one scene.
#include <fmt/format.h>
#include <memory>

#include "app/cli/command.h"
#include "app/error_time/frame_reports.h"
#include "app/frame/counted_frame.h"
#include "renderer/measure/double_path.h"

namespace kd {

namespace {

class Images {
  public:
    Images(const FrameReportTask& task, SceneErrorTime& result)
        : task_(task), result_(result),
          boxes_(task.opened.scene.triangles), images_{.scene = task.opened.scene,
                                                       .boxes = boxes_,
                                                       .config = task.opened.session.trace,
                                                       .plan = {},
                                                       .methods = {}} {
        images_.threads = task.opened.session.threads;
        images_.seed = task.opened.session.seed;
        images_.frame_seconds = 0.1 * task.seconds;
    }

    void measure() {
        for (FrameMachine& machine : task_.machines)
            for (const Traversal traversal : task_.config.traversals) add_method(machine, traversal);
        images_.plan = plan_images(0.85 * task_.seconds, probe(), probe_reference(), probe_side * probe_side);
        side_ = images_.plan.width;
        note_given_up();
        result_.images = report_images(images_, task_.progress, task_.stop);
        check();
    }

  private:
    void check() const {
        if (task_.stop.stop_requested()) throw Interrupted();
    }

    void add_method(FrameMachine& machine, Traversal traversal) {
        TraceConfig config = images_.config;
        config.traversal = traversal;
        config.counters = false;
        machine.tracer->prepare(config, side_, side_);
        images_.methods.push_back({machine.name, std::string(info(traversal).name), machine.tracer->clock(),
                                   [&machine, config, this](const PinholeCamera& camera, Image<Vec4>& colour) {
                                       const FrameTime time =
                                           machine.tracer->trace(config, camera, side_, side_, task_.stop);
                                       colour = machine.tracer->frame(config).colour;
                                       return time.sample();
                                   }});
    }

    /// The frames of a report have no counters, so a first one of each method has.
    void note_given_up() {
        const PinholeCamera camera = pinhole(images_.scene.camera, side_, side_);
        TraceConfig config = images_.config;
        for (FrameMachine& machine : task_.machines)
            for (const Traversal traversal : task_.config.traversals) {
                config.traversal = traversal;
                const auto frame = trace_counted(*machine.tracer, config, camera, side_, side_, task_.stop);
                check();
                note_unfinished(frame.value(), fmt::format("{} on {}", info(traversal).name, machine.name),
                                result_.notes);
            }
    }

    /// Wall clock of a small frame by each method, all that it takes; the second of two.
    [[nodiscard]] std::vector<double> probe() const {
        std::vector<double> times;
        const PinholeCamera camera = pinhole(images_.scene.camera, probe_side, probe_side);
        Image<Vec4> colour;
        for (const ImageMethod& method : images_.methods) {
            double ms = 0;
            for (int i = 0; i < 2; ++i) ms = wall_ms([&] { method.trace(camera, colour); });
            times.push_back(ms);
            check();
        }
        return times;
    }

    [[nodiscard]] double probe_reference() const {
        return wall_ms([&] {
            (void)double_frame(images_.scene, pinhole(images_.scene.camera, probe_side, probe_side), probe_side,
                               probe_side, path_config(images_.scene, images_.config), images_.threads, task_.stop,
                               &boxes_);
        });
    }

    const FrameReportTask& task_;
    SceneErrorTime& result_;
    TriangleBoxes boxes_;
    ImageTask images_;
    int side_ = probe_side;
};

}  // namespace

void measure_images(const FrameReportTask& task, SceneErrorTime& result) { Images(task, result).measure(); }

}  // namespace kd
