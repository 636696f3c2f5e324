#include "app/commands/bench_peers.h"

#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/progress_line.h"
#include "app/report/machine_info.h"
#include "app/report/peers_report.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/suited_tree.h"
#include "renderer/geometry/input_error.h"
#include "renderer/peers/peers.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

/// A tree and the tracers over it.
struct Tracers {
    std::string name;
    KdTree tree;
    std::vector<std::unique_ptr<CpuTracer>> all;
};

Tracers build(const std::string& name, PeersTree& made, PeersScene& peers, CommandContext& context) {
    Tracers over{name, {}, {}};
    BuildReport report;
    over.tree = build_tree(peers.scene.triangles, made.build, &report, {}, context.stop, peers.session.threads);
    check_stop(context);
    made.build_ms = 1e3 * report.seconds;
    peers.trees[name] = made;
    return over;
}

/// The tracer over one tree; packets of every size.
void add_own(const PeersScene& peers, TracerKind kind, Tracers& over, std::vector<RayContestant>& contestants) {
    over.all.push_back(std::make_unique<CpuTracer>(peers.scene, over.tree, cpu_mode(kind)));
    const bool packets = kind == TracerKind::cpu_packet;
    for (const int packet : packets ? std::vector{4, 8, 16} : std::vector{1}) {
        TraceConfig config = peers.session.trace;
        config.traversal = Traversal::stack;
        config.nodes = peers.trees.at(over.name).nodes;
        config.counters = false;
        if (packets) config.packet_size = packet;
        contestants.push_back(
            {std::string(name_of(kind)), packet, over.name,
             [tracer = over.all.back().get(), config](const BenchRays& rays, int threads, std::span<Hit> hits) {
                 tracer->trace_rays(config, rays.rays, rays.any_hit(), hits, {}, threads);
             }});
    }
}

void add_peers(const std::vector<std::unique_ptr<PeerTracer>>& peers, std::vector<RayContestant>& contestants) {
    for (const auto& peer : peers)
        contestants.push_back({std::string(peer->name()), peer->width(), "",
                               [peer = peer.get()](const BenchRays& rays, int threads, std::span<Hit> hits) {
                                   const PeerQuery query{rays.any_hit(), rays.coherent(), threads};
                                   peer->trace(rays.rays, query, hits);
                               }});
}

PeersScene open_peers(const CommonOptions& options, const PeerBenchOptions& how, const std::string& name,
                      const CommandContext& context) {
    PeersScene peers;
    peers.session = options.session_for(name);
    peers.session.trace.traversal = Traversal::stack;
    peers.session.threads = how.threads;
    peers.scene = open_scene(options, peers.session, context);
    if (scene_needs(peers.scene, KdTree{}, peers.session.trace).masks)
        throw InputError(fmt::format("--peers: {} has triangles with holes, which Embree here does not know; leave "
                                     "--peers out, or take a scene without alpha masks",
                                     peers.session.scene));
    peers.peers = peers_version();
    return peers;
}

/// The tree that is asked for, and those in which cpu-wide and cpu-packet are at their best.
std::vector<Tracers> build_trees(const CommonOptions& options, PeersScene& peers, CommandContext& context) {
    const Session& s = peers.session;
    std::vector<Tracers> trees;
    PeersTree asked{s.build, s.trace.nodes};
    trees.push_back(build("asked", asked, peers, context));
    for (const TracerKind kind : {TracerKind::cpu_wide, TracerKind::cpu_packet}) {
        PeersTree suited{suited_tree(cpu_mode(kind), s.build), s.trace.nodes};
        if (kind == TracerKind::cpu_packet && !options.nodes) suited.nodes = NodeEncoding::packed;
        trees.push_back(build(std::string(name_of(kind)), suited, peers, context));
    }
    return trees;
}

void time_all(const CommonOptions& options, const PeerBenchOptions& how, PeersScene& peers, ProgressLine& progress,
              CommandContext& context) {
    const Session& s = peers.session;
    std::vector<Tracers> trees = build_trees(options, peers, context);
    const auto rivals = make_peers(peers.scene);
    check_stop(context);
    std::vector<RayContestant> contestants;
    add_peers(rivals, contestants);
    for (Tracers& over : trees)
        for (const TracerKind kind : wanted_tracers(options))
            if (runs_on_cpu(kind) && (over.name == "asked" || over.name == name_of(kind)))
                add_own(peers, kind, over, contestants);
    const std::vector<BenchRays> rays = bench_rays(peers.scene, trees.front().tree, s.width, s.height, s.seed);
    const auto tell = [&](const std::string& running) {
        check_stop(context);
        progress.show(0, fmt::format("{}: {}", s.scene, running));
    };
    peers.result = bench_tracers(rays, contestants, {how.timing, how.threads, tell});
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
    PeersScene peers = open_peers(options, how, name, context);
    const std::string what = fmt::format("timing {} against {}", name, peers.peers);
    tell_work(context, what);
    {
        ProgressLine progress(context);
        progress.show(0, what);
        time_all(options, how, peers, progress, context);
    }
    peers.on = measured_on(in_scene_units(peers.session, peers.scene), {"scene", "tracer", "traversal"});
    if (how.json)
        for (Json& row : peers_json(peers)) json.push_back(std::move(row));
    else
        print(context.out, peers, how.timing.warmup);
    for (const std::string& line : peers.result.disagreements)
        context.err << fmt::format("kdscope: {}: {}\n", name, line);
    return peers.result.disagreements.empty();
}

}  // namespace kd
