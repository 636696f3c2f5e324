#include "app/paper/paper_node_sizes.h"

#include <fmt/format.h>

#include "app/frame/frame_tracer.h"

namespace kd {

PaperNodeSizes compare_node_sizes(const PaperConfig& config, const std::string& name, const PaperWorld& world,
                                  TracerKind tracer, const std::stop_token& stop) {
    const Session& base = config.base;
    const GlChoices gl{.context = config.context, .early_z = base.early_z};
    std::vector<Contestant> contestants;
    PaperNodeSizes sizes{name, tracer == TracerKind::gl_fragment, world.tree.nodes.size(), {}, {}, {}};
    for (const NodeEncoding nodes : {NodeEncoding::float4, NodeEncoding::packed}) {
        TraceConfig trace = base.trace;
        trace.traversal = Traversal::stack;
        trace.nodes = nodes;
        trace.counters = false;
        // Each has a tracer of its own: one for both would make the other's table before every frame.
        const std::shared_ptr<FrameTracer> own = make_frame_tracer(tracer, world.scene, world.tree, base.threads, gl);
        own->prepare(trace, base.width, base.height);
        contestants.push_back({fmt::format("nodes of {} bytes", bytes_of(nodes)), [&, own, trace] {
                                   if (stop.stop_requested()) return TimeSample{};
                                   const FrameTime time =
                                       own->trace(trace, world.camera, base.width, base.height, stop);
                                   sizes.clock = own->clock();  // known once there was a frame
                                   return time.sample();
                               }});
    }
    std::vector<TimedRounds> timed = time_in_turn(contestants, {.warmup = 2, .rounds = config.quick ? 9 : 15});
    sizes.wide = std::move(timed[0]);
    sizes.packed = std::move(timed[1]);
    return sizes;
}

}  // namespace kd
