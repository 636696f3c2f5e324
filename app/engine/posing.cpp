#include "app/engine/posing.h"

#include <utility>

#include "renderer/measure/timing.h"

namespace kd {

Posing::Makers::Makers(const PoseTask& task)
    : of(task.of->moving), build(task.build), refit(task.refit), threads(task.threads) {
    const std::vector<Triangle>& rest = of->at_rest().triangles;
    maker = std::make_unique<TreeMaker>(refit ? std::string(refit_way) : build.builder, build, rest, threads);
    if (refit) first_cost = tree_stats(maker->first(), rest.size(), build).sah_cost;
}

bool Posing::Makers::serve(const PoseTask& task) const {
    return maker && of == task.of->moving && build == task.build && refit == task.refit && threads == task.threads;
}

void Posing::start(const PoseTask& task, std::function<void(const Posed&)> done) {
    busy_ = true;
    const auto posed = std::make_shared<Posed>();
    posed->task = task;
    run_.start(
        "the pose", [this, posed](const std::stop_token& stop, const BackgroundRun::Post&) { make(*posed, stop); },
        [this, posed, done = std::move(done)](const std::string& error) {
            busy_ = false;
            posed->error = error;
            done(*posed);
        });
}

void Posing::cancel() {
    run_.cancel();
    busy_ = false;
}

/// On the thread that poses.
void Posing::make(Posed& posed, const std::stop_token& stop) {
    const PoseTask& task = posed.task;
    auto loaded =
        std::make_shared<LoadedScene>(LoadedScene{task.of->name, task.of->seed, {}, task.time, task.of->moving});
    auto world = std::make_shared<World>();
    world->steps[FrameStep::update].begin = steady_seconds();
    loaded->flat = loaded->moving->at(task.time);
    world->steps[FrameStep::update].end = steady_seconds();
    // The tree that refitting keeps the planes of is made once, for no frame in particular.
    if (!makers_.serve(task)) makers_ = Makers(task);
    world->steps[FrameStep::build].begin = steady_seconds();
    const int refused = makers_.maker->refused();
    world->tree = makers_.maker->make(loaded->flat.triangles, stop, &world->report);
    world->steps[FrameStep::build].end = steady_seconds();
    if (stop.stop_requested()) return;
    world->refitted = task.refit && makers_.maker->refused() == refused;
    world->built_with = task.build;
    world->stats = tree_stats(world->tree, loaded->flat.triangles.size(), task.build);
    world->facts = scene_facts(loaded->flat, world->tree);
    world->loaded = std::move(loaded);

    posed.made = ++makers_.made;
    posed.refused = makers_.maker->refused();
    posed.why_refused = makers_.maker->why_refused();
    posed.first_cost = makers_.first_cost;
    posed.world = std::move(world);
}

}  // namespace kd
