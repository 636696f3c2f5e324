#include "app/error_time/frame_machines.h"

#include "app/choices.h"
#include "app/cli/command.h"
#include "app/error_time/error_time_run.h"
#include "app/frame/open_or_note.h"

namespace kd {

namespace {

FrameMachine opened_machine(TracerKind kind, const ErrorTimeConfig& config, const OpenedScene& opened,
                            const KdTree& tree) {
    const GlChoices gl{.context = config.context, .early_z = opened.session.early_z};
    FrameMachine machine{kind, std::string(name_of(kind)),
                         make_frame_tracer(kind, opened.scene, tree, opened.session.threads, gl)};
    TraceConfig trace = opened.session.trace;
    trace.counters = false;
    if (!config.traversals.empty()) trace.traversal = config.traversals.front();
    machine.tracer->prepare(trace, probe_side, probe_side);
    (void)machine.tracer->trace(trace, pinhole(opened.scene.camera, probe_side, probe_side), probe_side, probe_side);
    return machine;
}

}  // namespace

std::vector<FrameMachine> open_machines(const ErrorTimeConfig& config, const OpenedScene& opened, const KdTree& tree,
                                        const MachineMissing& missing, const std::stop_token& stop) {
    const AskedFor asked{config.gl_demanded, config.gl_demanded};
    std::vector<FrameMachine> machines;
    for (const TracerKind kind : config.tracers) {
        open_or_note(
            asked, [&] { machines.push_back(opened_machine(kind, config, opened, tree)); },
            [&](const std::string& why) { missing(std::string(name_of(kind)), why); });
        if (stop.stop_requested()) throw Interrupted();
    }
    return machines;
}

}  // namespace kd
