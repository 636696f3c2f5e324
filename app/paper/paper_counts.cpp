#include "app/paper/paper_counts.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/report/json_values.h"
#include "app/scenes.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "viz/divergence.h"
#include "viz/figure.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

/// A counted frame on all threads: what is counted does not depend on them.
Frame counted_frame(const PaperConfig& config, const PaperWorld& world, const TraceConfig& trace,
                    const std::stop_token& stop) {
    Frame frame(config.base.width, config.base.height);
    CpuTracer tracer(world.scene, world.tree);
    tracer.trace_frame(trace, world.camera, frame, 0, stop);
    return frame;
}

TraceConfig counting(const PaperConfig& config, Traversal traversal) {
    TraceConfig trace = config.base.trace;
    trace.traversal = traversal;
    trace.counters = true;
    return trace;
}

/// The image with what ended at the step budget in the map's colours.
std::shared_ptr<const Image<Rgba8>> picture_of(const Frame& frame, const PaperWorld& world) {
    ViewConfig view;
    view.show_map = true;
    view.map.map = "exit";
    view.heat.opacity = 1;
    return std::make_shared<const Image<Rgba8>>(make_picture(frame, world.tree, world.scene.camera, view));
}

std::string file_name(const std::string& scene, int budget) {
    std::string stem = scene;
    std::ranges::replace(stem, ':', '-');
    return fmt::format("budget-{}-{}.png", stem, budget);
}

}  // namespace

std::unique_ptr<PaperWorld> open_world(const PaperConfig& config, const std::string& scene, unsigned seed,
                                       const std::stop_token& stop) {
    auto world = std::make_unique<PaperWorld>();
    world->scene = load_scene(scene, seed);
    BuildReport report;
    world->tree = build_tree(world->scene.triangles, config.base.build, &report, {}, stop, config.base.threads);
    if (stop.stop_requested()) return nullptr;
    world->build_ms = 1e3 * report.seconds;
    world->camera = pinhole(world->scene.camera, config.base.width, config.base.height);
    return world;
}

PaperScene count_scene(const PaperConfig& config, const std::string& name, const PaperWorld& world,
                       const std::stop_token& stop) {
    PaperScene scene;
    scene.name = name;
    scene.triangles = world.scene.triangles.size();
    scene.nodes = world.tree.nodes.size();
    scene.build_ms = world.build_ms;
    scene.rays = count_rays(world.scene, world.tree, config.base.trace, world.camera, config.base.width,
                            config.base.height, stop);
    for (const Traversal traversal : {Traversal::stack, Traversal::restart, Traversal::backtrack}) {
        const Frame frame = counted_frame(config, world, counting(config, traversal), stop);
        if (stop.stop_requested()) break;
        const EfficiencySummary divergence =
            summarise_divergence(frame.layer(Pass::rt_prim), paper_tile_width, paper_tile_height);
        scene.counts.push_back({traversal, sum_of(pass_totals(frame)), divergence.weighted});
    }
    return scene;
}

double seed_node_ratio(const PaperConfig& config, const std::string& name, unsigned seed, const std::stop_token& stop) {
    const std::unique_ptr<PaperWorld> world = open_world(config, name, seed, stop);
    if (!world) return 0;
    std::array<std::uint64_t, 2> interior{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Traversal traversal = i == 0 ? Traversal::stack : Traversal::restart;
        const Frame frame = counted_frame(config, *world, counting(config, traversal), stop);
        const CounterTotals all = sum_of(pass_totals(frame));
        interior[i] = all.interior_first + all.interior_again;
    }
    return interior[0] > 0 && !stop.stop_requested() ? double(interior[1]) / double(interior[0]) : 0;
}

PaperBudget limited_loop(const PaperConfig& config, const std::string& name, const PaperWorld& world, int budget,
                         PaperPicture* picture, const std::stop_token& stop) {
    TraceConfig trace = counting(config, Traversal::restart);
    trace.step_budget = budget;
    const Frame frame = counted_frame(config, world, trace, stop);
    const UnfinishedPixels unfinished = count_unfinished(frame);
    const PaperBudget row{name, world.scene.triangles.size(), budget,
                          std::int64_t(config.base.width) * config.base.height, unfinished.pixels};
    if (picture)
        *picture = {
            file_name(name, budget),
            fmt::format("{}, at most {} steps: {} of {} pixels unfinished", name, budget, row.unfinished, row.pixels),
            picture_of(frame, world)};
    return row;
}

}  // namespace kd
