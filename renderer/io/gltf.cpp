#include "renderer/io/gltf.h"

#include <algorithm>
#include <cctype>
#include <glm/vec4.hpp>
#include <memory>
#include <utility>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/gltf_accessor.h"
#include "renderer/io/gltf_animation.h"
#include "renderer/io/gltf_deform.h"
#include "renderer/io/gltf_material.h"
#include "renderer/io/gltf_mesh.h"
#include "renderer/io/gltf_node.h"
#include "renderer/io/gltf_parse.h"
#include "renderer/io/gltf_view.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

/// Instances for all nodes with a mesh; each mesh is added once however many nodes show it, and again for each node
/// that deforms it. What deforms meshes goes into `rig`.
void add_instances(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes, Rig& rig,
                   Scene& scene) {
    std::vector<std::uint64_t> uses(model.meshes.size(), 0);
    for (const PlacedNode& node : nodes) {
        const int mesh = model.nodes[node.node].mesh;
        if (mesh >= 0) ++uses[static_cast<std::size_t>(mesh)];
    }
    check_mesh_sizes(context, model, uses);

    GltfMaterials materials(context, model, scene);
    std::vector<std::vector<GltfPart>> parts(model.meshes.size());
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        if (uses[i] > 0) parts[i] = add_gltf_mesh(context, model, i, materials, scene);
    }
    GltfDeformer deformer(context, model, nodes, rig);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const tinygltf::Node& node = model.nodes[nodes[i].node];
        if (node.mesh < 0) continue;
        const auto mesh = static_cast<std::size_t>(node.mesh);
        for (GltfPart part : parts[mesh]) {
            const bool deforms = deformer.deforms(node, part);
            if (deforms && uses[mesh] > 1) {
                scene.meshes.push_back(scene.meshes[static_cast<std::size_t>(part.mesh)]);
                part.mesh = static_cast<int>(scene.meshes.size()) - 1;
            }
            scene.instances.push_back({part.mesh, glm::mat4(nodes[i].to_world)});
            rig.node_of_instance.push_back(i);
            if (deforms) deformer.add(scene, part, i, nodes[i].node);
        }
    }
}

/// Lets the rig pose scene and nodes as they are at 0 s, and the scene move where the rig does.
void add_motion(GltfContext& context, const tinygltf::Model& model, Rig rig, std::vector<PlacedNode>& nodes,
                Scene& scene) {
    if (rig.channels.empty() && rig.meshes.empty()) return;
    const auto motion = std::make_shared<const RigMotion>(std::move(rig));
    motion->pose(scene, 0.0);
    const std::vector<glm::dmat4> world = motion->to_world(0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].to_world = world[i];
    if (motion->duration() == 0.0) return;
    scene.motion = motion;
    if (!model.cameras.empty() || !model.lights.empty())
        context.note("kept cameras and lights where they are at 0 s of the animation");
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
    std::vector<PlacedNode> nodes = placed_nodes(context, model);
    Scene scene;
    Rig rig = read_rig(context, model, nodes);
    add_instances(context, model, nodes, rig, scene);
    add_motion(context, model, std::move(rig), nodes, scene);
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
