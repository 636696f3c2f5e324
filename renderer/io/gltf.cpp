#include "renderer/io/gltf.h"

#include <algorithm>
#include <cctype>
#include <glm/vec4.hpp>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/gltf_accessor.h"
#include "renderer/io/gltf_material.h"
#include "renderer/io/gltf_mesh.h"
#include "renderer/io/gltf_node.h"
#include "renderer/io/gltf_parse.h"
#include "renderer/io/gltf_view.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

/// Instances for all nodes with a mesh; each mesh is added once however many nodes show it.
void add_instances(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                   Scene& scene) {
    std::vector<std::uint64_t> uses(model.meshes.size(), 0);
    for (const PlacedNode& node : nodes) {
        const int mesh = model.nodes[node.node].mesh;
        if (mesh >= 0) ++uses[static_cast<std::size_t>(mesh)];
    }
    check_mesh_sizes(context, model, uses);

    GltfMaterials materials(context, model, scene);
    std::vector<std::vector<int>> parts(model.meshes.size());
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        if (uses[i] > 0) parts[i] = add_gltf_mesh(context, model, i, materials, scene);
    }
    for (const PlacedNode& node : nodes) {
        const int mesh = model.nodes[node.node].mesh;
        if (mesh < 0) continue;
        for (const int part : parts[static_cast<std::size_t>(mesh)]) {
            scene.instances.push_back({part, glm::mat4(node.to_world)});
        }
    }
}

Aabb world_bounds(const Scene& scene) {
    Aabb bounds;
    for (const Instance& instance : scene.instances) {
        // By the corners of triangles: a mesh may hold far more positions than it uses, and be shown often.
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const std::uint32_t vertex : mesh.indices) {
            const Vec3 world(instance.to_world * Vec4(mesh.positions[vertex], 1.0f));
            // Written so that NaN fails; flatten() drops such triangles.
            const bool usable = glm::dot(glm::abs(world), Vec3(1.0f)) <= KD_COORDINATE_LIMIT;
            if (usable) bounds.include(world);
        }
    }
    return bounds;
}

Scene convert(GltfContext& context, const tinygltf::Model& model) {
    check_accessors(context, model);
    const std::vector<PlacedNode> nodes = placed_nodes(context, model);
    Scene scene;
    add_instances(context, model, nodes, scene);
    if (!model.animations.empty() || !model.skins.empty()) {
        context.note("shown skins, morph targets and animations in their static pose");
    }
    const Aabb bounds = world_bounds(scene);
    scene.camera = first_camera(context, model, nodes, bounds);
    scene.lights = punctual_lights(context, model, nodes, bounds);
    return scene;
}

}  // namespace

bool names_gltf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".gltf" || extension == ".glb";
}

Scene load_gltf(const std::filesystem::path& path, const GltfLimits& limits) {
    return decode_gltf(read_file(path), path, limits);
}

Scene decode_gltf(std::string_view bytes, const std::filesystem::path& path, const GltfLimits& limits) {
    GltfContext context(path.string(), limits);
    Scene scene;
    try {
        scene = convert(context, parse_gltf(context, bytes, path));
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        context.fail("", "needs more memory than there is; use a smaller scene");
    } catch (const std::exception& error) {
        // From tinygltf or its JSON, on something that the checks before it let pass.
        context.fail("", std::string("cannot be decoded: ") + error.what());
    }
    scene.name = printable(path.filename().string());
    scene.notes = context.notes();
    return scene;
}

}  // namespace kd
