#include "app/commands/bench_peers.h"

#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/progress_line.h"
#include "app/report/machine_info.h"
#include "app/report/peers_report.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/geometry/input_error.h"
#include "renderer/peers/peers.h"

namespace kd {

namespace {

constexpr int wide_block = 8;  // triangles that cpu-wide and cpu-packet test at once

/// A tree and the tracers over it.
struct Tracers {
    KdTree tree;
    BuildReport built;
    std::vector<std::unique_ptr<CpuTracer>> all;
};

Tracers build(const FlatScene& scene, const BuildConfig& config, int threads, CommandContext& context) {
    Tracers made;
    made.tree = build_tree(scene.triangles, config, &made.built, {}, context.stop, threads);
    check_stop(context);
    return made;
}

/// The tracer over one tree; packets of every size, as far as --packet does not name one.
void add_own(const CommonOptions& options, const FlatScene& scene, TracerKind kind, int leaf_block, Tracers& over,
             std::vector<RayContestant>& contestants) {
    over.all.push_back(std::make_unique<CpuTracer>(scene, over.tree, cpu_mode(kind)));
    const bool packets = kind == TracerKind::cpu_packet;
    for (const int packet : packets ? std::vector{4, 8, 16} : std::vector{1}) {
        TraceConfig config = options.session.trace;
        config.traversal = Traversal::stack;
        config.counters = false;
        if (packets) config.packet_size = packet;
        contestants.push_back(
            {std::string(name_of(kind)), packet, leaf_block,
             [tracer = over.all.back().get(), config](const BenchRays& rays, int threads, std::span<Hit> hits) {
                 tracer->trace_rays(config, rays.rays, rays.any_hit(), hits, {}, threads);
             }});
    }
}

void add_peers(const std::vector<std::unique_ptr<PeerTracer>>& peers, std::vector<RayContestant>& contestants) {
    for (const auto& peer : peers)
        contestants.push_back({std::string(peer->name()), peer->width(), 0,
                               [peer = peer.get()](const BenchRays& rays, int threads, std::span<Hit> hits) {
                                   const PeerQuery query{rays.any_hit(), rays.coherent(), threads};
                                   peer->trace(rays.rays, query, hits);
                               }});
}

}  // namespace

void check_peers(const CommonOptions& options) {
    if (peers_version().empty())
        throw InputError("--peers: this program was built without Embree 3; install libembree-dev and build again");
    if (options.tracer && !runs_on_cpu(*options.tracer))
        throw InputError("--peers: the peers run on the CPU; name one of its tracers, or leave --tracer out");
    if (options.traversal && *options.traversal != Traversal::stack)
        throw InputError("--peers: rays walk by the stack; leave --traversal out");
}

bool bench_peers(const CommonOptions& options, const PeerBenchOptions& how, const std::string& name, Json& json,
                 CommandContext& context) {
    PeersScene peers;
    peers.session = options.session_for(name);
    Session& s = peers.session;
    s.trace.traversal = Traversal::stack;
    s.threads = how.threads;
    peers.scene = open_scene(options, s);
    peers.peers = peers_version();
    const std::string what = fmt::format("timing {} against {}", name, peers.peers);
    tell_work(context, what);
    ProgressLine progress(context);
    progress.show(0, what);

    std::vector<int> blocks{s.build.leaf_block};
    if (s.build.leaf_block != wide_block) blocks.push_back(wide_block);
    std::vector<Tracers> trees;
    for (const int block : blocks) {
        BuildConfig config = s.build;
        config.leaf_block = block;
        trees.push_back(build(peers.scene, config, s.threads, context));
        peers.build_ms[block] = 1e3 * trees.back().built.seconds;
    }
    const auto rivals = make_peers(peers.scene);
    check_stop(context);
    std::vector<RayContestant> contestants;
    add_peers(rivals, contestants);
    for (std::size_t i = 0; i < trees.size(); ++i)
        for (const TracerKind kind : wanted_tracers(options))
            if (runs_on_cpu(kind)) add_own(options, peers.scene, kind, blocks[i], trees[i], contestants);
    const std::vector<BenchRays> rays = bench_rays(peers.scene, trees.front().tree, s.width, s.height, s.seed);
    const auto tell = [&](const std::string& running) {
        check_stop(context);
        progress.show(0, fmt::format("{}: {}", name, running));
    };
    peers.result = bench_tracers(rays, contestants, {how.timing, how.threads, tell});
    progress.wipe();
    peers.on = measured_on(in_scene_units(s, peers.scene), {"scene", "tracer", "traversal"});
    if (how.json)
        for (Json& row : peers_json(peers)) json.push_back(std::move(row));
    else
        print(context.out, peers, how.timing.warmup);
    for (const std::string& line : peers.result.disagreements)
        context.err << fmt::format("kdscope: {}: {}\n", name, line);
    return peers.result.disagreements.empty();
}

}  // namespace kd
