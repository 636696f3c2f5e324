// What `stats --divergence` and `stats --ballot` do.
#pragma once

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "renderer/kdtree/tree.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace kd {

struct DivergenceOptions {
    bool divergence = false, ballot = false;
    std::optional<Pass> rays;  // those given; else all that there are
    int tile_width = 0, tile_height = 0;
    std::string csv, svg;
    std::string maps;  // folder
};

/// A scene of a command that walks rays through its tree.
struct WalkedScene {
    Session session;
    FlatScene scene;
    KdTree tree;
    PinholeCamera camera;

    /// What to walk for one table. The scene must outlive it.
    [[nodiscard]] WalkRequest request(Traversal traversal, Pass rays) const;
};
/// The tree that the session asks for; what is to be told of it goes to the error stream. Interrupted.
[[nodiscard]] KdTree told_tree(const FlatScene& scene, const Session& session, CommandContext& context);
/// InputError, Interrupted.
[[nodiscard]] WalkedScene open_walked(const CommonOptions& common, const std::string& name, CommandContext& context);

void add_divergence_options(CLI::App& app, DivergenceOptions& options);

/// Those asked for, or those that scene and settings have.
[[nodiscard]] std::vector<Pass> rays_of(const FlatScene& scene, const TraceConfig& config,
                                        const DivergenceOptions& options);

/// The path of chart `number`, from 0: "width.svg", "width-2.svg", ... Names of charts must not clash.
[[nodiscard]] std::string numbered(const std::string& path, std::size_t number);

/// "ball:9000: 8998 triangles, ...; 512x512", with the end of the line.
[[nodiscard]] std::string heading_of(const WalkedScene& walked);

/// Charts as SVG, each with the path that it goes to.
using ChartTexts = std::vector<std::pair<std::string, std::string>>;
/// The table that was asked for as CSV, and the charts; says so, a line each.
void write_files(const DivergenceOptions& options, const std::string& csv, const ChartTexts& charts,
                 const CommandContext& context);

/// Efficiency against width, per scene, traversal and kind of ray.
int run_divergence(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context);

/// Lanes counted by the GPU against lanes computed. exit_failed where a software renderer's are not the same.
int run_ballots(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context);

}  // namespace kd
