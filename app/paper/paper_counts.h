// The parts of the paper's experiments in which nothing is timed: scenes, trees, counters, limited loops.
#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "app/paper/paper_run.h"
#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"

namespace kd {

/// A scene with its tree: what tracers need to stay alive.
struct PaperWorld {
    FlatScene scene;
    KdTree tree;
    double build_ms = 0;
    PinholeCamera camera{};
};

/// InputError. Null where stopped.
[[nodiscard]] std::unique_ptr<PaperWorld> open_world(const PaperConfig& config, const std::string& scene, unsigned seed,
                                                     const std::stop_token& stop);

/// Name, sizes, rays, and counts of stack, restart and backtrack. Nothing is timed.
[[nodiscard]] PaperScene count_scene(const PaperConfig& config, const std::string& name, const PaperWorld& world,
                                     const std::stop_token& stop);

/// Interior nodes of restart over those of the stack in the scene made from `seed`; 0 where stopped.
[[nodiscard]] double seed_node_ratio(const PaperConfig& config, const std::string& name, unsigned seed,
                                     const std::stop_token& stop);

/// Kd-restart with no more than `budget` steps; with a picture of what was given up where asked for.
[[nodiscard]] PaperBudget limited_loop(const PaperConfig& config, const std::string& name, const PaperWorld& world,
                                       int budget, PaperPicture* picture, const std::stop_token& stop);

}  // namespace kd
