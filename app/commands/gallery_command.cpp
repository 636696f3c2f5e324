// gallery: a few pictures that show what the program does.

#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/assets.h"
#include "app/cli/idle_options.h"
#include "app/cli/output_file.h"
#include "app/commands/commands.h"
#include "app/fonts.h"
#include "app/frame/rendering.h"
#include "renderer/geometry/input_error.h"
#include "viz/unfinished.h"

namespace kd {

namespace {

namespace fs = std::filesystem;

struct GalleryOptions : CommonOptions {
    std::string folder;
};

struct Picture {
    const char* name;
    const char* map;  // null: none
    bool overlay;
};
constexpr std::array<Picture, 4> pictures{{{"beauty", nullptr, false},
                                           {"nodes", "nodes", false},
                                           {"divergence", "divergence", false},
                                           {"splits", nullptr, true}}};

struct GalleryScene {
    std::string name;
    int split_depth;  // shows the tree's shape without burying the image
};

constexpr const char* scene_at_random = "scatter:10000";

std::vector<GalleryScene> gallery_scenes() {
    std::vector<GalleryScene> scenes{{"ball:9000", 9}, {"rooms", 10}, {scene_at_random, 5}};
    const auto lantern = find_asset("scenes/lantern.gltf");
    if (!lantern)
        throw InputError(
            "lantern.gltf: not found, a scene that comes with the program; set KDSCOPE_ASSETS to its folder 'assets'");
    scenes.push_back({lantern->string(), 9});
    return scenes;
}

ViewConfig view_of(const Picture& picture, const GalleryScene& scene) {
    ViewConfig view;
    view.show_map = picture.map != nullptr;
    if (picture.map) view.map.map = picture.map;
    view.heat.opacity = 1.0f;
    view.overlay.show = picture.overlay;
    view.overlay.max_depth = scene.split_depth;
    return view;
}

std::string path_of(const GalleryOptions& options, const GalleryScene& scene, const Picture& picture) {
    return (fs::path(options.folder) / fmt::format("{}-{}.png", file_stem(scene.name), picture.name)).string();
}

int run(const CLI::App& app, const GalleryOptions& options, CommandContext& context) {
    note_idle(app, shared_uses(options, options.session_for(scene_at_random), false), context);
    const std::vector<GalleryScene> scenes = gallery_scenes();
    require_context(options, false);
    make_output_folder("--output", options.folder);
    std::vector<OutputFile> outputs;
    for (const GalleryScene& scene : scenes)
        for (const Picture& picture : pictures) outputs.push_back({"--output", path_of(options, scene, picture)});
    check_outputs(outputs, {});
    const Font font = picture_font();
    for (const GalleryScene& scene : scenes) {
        Rendering rendering = render(options, options.session_for(scene.name), context);
        if (const UnfinishedPixels unfinished = count_unfinished(rendering.frame); unfinished.pixels > 0)
            context.err << fmt::format("kdscope: note: {}: {}\n", scene.name, unfinished_text(unfinished));
        rendering.session.scene = fs::path(scene.name).filename().string();
        for (const Picture& picture : pictures) {
            check_stop(context);
            const std::string path = path_of(options, scene, picture);
            write_picture(path, rendering, view_of(picture, scene), true, font);
            context.out << path << '\n' << std::flush;
        }
    }
    return exit_ok;
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<GalleryOptions>();
    options->session.width = 640;
    options->session.height = 480;
    app.add_option("-o,--output", options->folder, "Folder for the pictures; made if missing")
        ->required()
        ->type_name("FOLDER");
    add_size_option(app, *options);
    add_machine_options(app, *options);
    add_tracing_options(app, *options);
    add_tree_options(app, *options);
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command gallery_command() {
    return {"gallery", "Writes pictures of several scenes: image, node heatmap, divergence map, splits",
            "Prints the path of every picture.\n\n"
            "Example:\n"
            "  kdscope gallery -o out\n",
            declare};
}

}  // namespace kd
