// Rays at edges and vertices of a closed sphere, from inside: how many slip out, for every traversal and for Embree.
//
// usage: watertight_bench [RAYS]      default 1000000 of each kind; exits 1 where a traversal of kdscope misses

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/peers/peers.h"
#include "renderer/scene/stress_shapes.h"

namespace {

using namespace kd;

std::ptrdiff_t misses(const std::vector<Hit>& hits) { return std::ranges::count(hits, -1, &Hit::triangle); }

int run(std::size_t count) {
    const FlatScene scene = bare_scene(stress_sphere(80, 40));
    const KdTree tree = build_tree(scene.triangles, {});
    CpuTracer tracer(scene, tree);
    Random random(1);
    const auto origin = [&] { return random_point(random, -0.3f, 0.3f); };
    const std::vector<Ray> edges = rays_to_edges(random, scene.triangles, count, origin);
    const std::vector<Ray> vertices = rays_to_vertices(random, scene.triangles, count, origin);
    std::vector<Hit> hits(count);
    std::ptrdiff_t ours = 0;

    std::printf("closed sphere of %zu triangles, %zu rays each; misses:\n%-20s %10s %10s\n", scene.triangles.size(),
                count, "tracer", "edges", "vertices");
    const auto row = [&](const std::string& name, const auto& trace) {
        trace(edges);
        const std::ptrdiff_t at_edges = misses(hits);
        trace(vertices);
        const std::ptrdiff_t at_vertices = misses(hits);
        std::printf("%-20s %10td %10td\n", name.c_str(), at_edges, at_vertices);
        return at_edges + at_vertices;
    };
    for (const TraversalInfo& t : traversals()) {
        if (t.id == Traversal::naive) continue;
        TraceConfig config;
        config.traversal = t.id;
        ours += row("kdscope " + std::string(t.name),
                    [&](const std::vector<Ray>& rays) { tracer.trace_rays(config, rays, false, hits, {}); });
    }
    for (const auto& peer : make_peers(scene))
        row(std::string(peer->name()), [&](const std::vector<Ray>& rays) { peer->trace(rays, {.threads = 0}, hits); });
    return ours == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? std::stoul(argv[1]) : 1'000'000);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "watertight_bench: %s\n", error.what());
        return 2;
    }
}
