#include "renderer/geometry/input_error.h"
#include "renderer/io/gltf.h"
#include "renderer/kdtree/build.h"
#include "renderer/kdtree/validate.h"
#include "renderer/scene/moving_scene.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/targets.h"

namespace kd::fuzz {

namespace {

/// So small that one input takes milliseconds, and that inputs of a few kilobytes reach every limit.
constexpr GltfLimits small_limits{.json_values = 20'000,
                                  .buffer_bytes = 1 << 20,
                                  .image_file_bytes = 1 << 16,
                                  .image_bytes = 1 << 18,
                                  .image_pixels = 1 << 14,
                                  .all_image_pixels = 1 << 16,
                                  .triangles = 300,
                                  .vertices = 3000,
                                  .instances = 300,
                                  .deformed = 30'000,
                                  .key_values = 3000,
                                  .lights = 8,
                                  .notes = 20};

void check(const FlatScene& flat) {
    promise(flat.triangles.size() <= small_limits.triangles, "the limit of triangles holds");
    promise(flat.triangles.size() == flat.attributes.size(), "every triangle has its attributes");
    promise(is_valid(flat.camera), "the camera can be used");
    promise_one_line(flat.name);
    for (const std::string& note : flat.notes) promise_one_line(note);
    for (const Builder& builder : builders()) {
        BuildConfig config;
        config.builder = builder.name;
        const KdTree tree = build_tree(flat.triangles, config);
        for (const Violation& violation : validate(tree, flat.triangles, 1)) promise(false, violation.message);
    }
}

}  // namespace

void gltf(std::string_view bytes) {
    // The folder does not exist, so that no input can make the loader read a file of this machine.
    const std::string file = bytes.starts_with('{') ? "no-such-folder/fuzz.gltf" : "no-such-folder/fuzz.glb";
    try {
        const MovingScene scene(decode_gltf(bytes, file, small_limits));
        check(scene.at_rest());
        if (scene.duration() > 0.0) check(scene.at(0.6 * scene.duration()));
    } catch (const InputError& error) {
        promise_one_line(error.what());
        promise(std::string_view(error.what()).starts_with(file + ": "), "errors name the file");
    }
}

}  // namespace kd::fuzz
