#include "renderer/io/gltf_deform.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "renderer/io/gltf_accessor.h"

namespace kd {

namespace {

constexpr int most_joint_sets = 16;  // of four joints each

int joint_set_count(const tinygltf::Primitive& primitive) {
    int sets = 0;
    while (sets < most_joint_sets && find_attribute(primitive.attributes, "JOINTS_" + std::to_string(sets)) >= 0 &&
           find_attribute(primitive.attributes, "WEIGHTS_" + std::to_string(sets)) >= 0)
        ++sets;
    return sets;
}

}  // namespace

GltfDeformer::GltfDeformer(GltfContext& context, const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                           Rig& rig)
    : context_(context), model_(model), rig_(rig), skins_(model.skins.size(), -1) {
    const std::vector<int> place = places_of(nodes, model);
    for (std::size_t i = 0; i < model.skins.size(); ++i)
        if (add_skin(model.skins[i], place)) skins_[i] = int(rig_.skins.size()) - 1;
}

bool GltfDeformer::add_skin(const tinygltf::Skin& skin, const std::vector<int>& place) {
    RigSkin added;
    for (const int joint : skin.joints) {
        if (place[std::size_t(joint)] < 0) {
            context_.count("ignored", "skin", " with joints outside of the scene");
            return false;
        }
        added.joints.push_back(std::size_t(place[std::size_t(joint)]));
    }
    added.inverse_bind.assign(added.joints.size(), glm::dmat4(1.0));
    if (skin.inverseBindMatrices >= 0) {
        const tinygltf::Accessor& a = model_.accessors[std::size_t(skin.inverseBindMatrices)];
        if (a.type != TINYGLTF_TYPE_MAT4 || a.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
            a.count < added.joints.size() || a.count > context_.limits().key_values / 16) {
            context_.count("ignored", "skin", " whose inverse bind matrices do not go with its joints");
            return false;
        }
        const std::vector<float> values = read_floats(context_, model_, skin.inverseBindMatrices);
        for (std::size_t i = 0; i < added.joints.size(); ++i) {
            added.inverse_bind[i] = glm::dmat4(glm::make_mat4(&values[16 * i]));  // by columns in both
        }
    }
    rig_.skins.push_back(std::move(added));
    return true;
}

int GltfDeformer::skin_of(const tinygltf::Node& node) const {
    return node.skin < 0 ? -1 : skins_[std::size_t(node.skin)];
}

const tinygltf::Primitive& GltfDeformer::primitive_of(const tinygltf::Node& node, const GltfPart& part) const {
    return model_.meshes[std::size_t(node.mesh)].primitives[part.primitive];
}

bool GltfDeformer::deforms(const tinygltf::Node& node, const GltfPart& part) const {
    const tinygltf::Primitive& primitive = primitive_of(node, part);
    return !primitive.targets.empty() || (skin_of(node) >= 0 && joint_set_count(primitive) > 0);
}

void GltfDeformer::add(const Scene& scene, const GltfPart& part, std::size_t place, std::size_t node) {
    const tinygltf::Node& of = model_.nodes[node];
    const tinygltf::Primitive& primitive = primitive_of(of, part);
    const Mesh& mesh = scene.meshes[std::size_t(part.mesh)];
    charge(mesh.positions.size(), 1 + primitive.targets.size() + std::uint64_t(joint_set_count(primitive)));

    RigMesh added{.instance = scene.instances.size() - 1, .mesh = std::size_t(part.mesh), .node = place};
    added.weights = of.weights.empty() ? model_.meshes[std::size_t(of.mesh)].weights : of.weights;
    added.rest.positions = mesh.positions;
    added.rest.normals = mesh.normals;
    read_targets(primitive, added.rest);
    if (skin_of(of) >= 0 && joint_set_count(primitive) > 0) {
        added.skin = skin_of(of);
        read_joints(primitive, rig_.skins[std::size_t(added.skin)].joints.size(), added.rest);
    }
    rig_.meshes.push_back(std::move(added));
}

void GltfDeformer::read_targets(const tinygltf::Primitive& primitive, Deformable& rest) {
    const std::size_t vertices = rest.positions.size();
    for (const auto& target : primitive.targets) {
        MorphTarget read;
        read.positions = read_vertex_vectors(context_, model_, find_attribute(target, "POSITION"), vertices,
                                             "positions of morph targets");
        if (!rest.normals.empty())
            read.normals = read_vertex_vectors(context_, model_, find_attribute(target, "NORMAL"), vertices,
                                               "normals of morph targets");
        rest.targets.push_back(std::move(read));
    }
}

void GltfDeformer::read_joints(const tinygltf::Primitive& primitive, std::size_t joints, Deformable& rest) {
    const std::size_t vertices = rest.positions.size();
    std::vector<std::pair<std::vector<Vec4>, std::vector<Vec4>>> sets;  // joints, weights
    for (int set = 0; set < joint_set_count(primitive); ++set) {
        const auto read = [&](const char* name, const char* noun) {
            const int accessor = find_attribute(primitive.attributes, name + std::to_string(set));
            return read_vertex_quadruples(context_, model_, accessor, vertices, noun);
        };
        auto numbers = read("JOINTS_", "joints"), weights = read("WEIGHTS_", "weights");
        if (!numbers.empty() && !weights.empty()) sets.emplace_back(std::move(numbers), std::move(weights));
    }
    std::uint64_t unusable = 0, unmoved = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        rest.first.push_back(rest.joints.size());
        for (const auto& [numbers, weights] : sets) {
            for (int i = 0; i < 4; ++i) {
                const float joint = numbers[vertex][i], weight = weights[vertex][i];
                if (weight == 0.0f) continue;
                // Written so that NaN fails.
                const bool usable = weight > 0.0f && std::isfinite(weight) && joint >= 0.0f && joint < float(joints);
                if (usable) rest.joints.push_back({std::uint32_t(joint), weight});
                unusable += usable ? 0 : 1;
            }
        }
        unmoved += rest.first.back() == rest.joints.size() ? 1 : 0;
    }
    rest.first.push_back(rest.joints.size());
    if (unusable > 0) context_.count("ignored", "joint weight", ", negative or of one that the skin lacks", unusable);
    if (unmoved > 0) context_.count("left", "position", " without joint weights where the mesh has it", unmoved);
}

void GltfDeformer::charge(std::uint64_t vertices, std::uint64_t times) {
    const std::uint64_t limit = context_.limits().deformed;
    // Cut to just above the limit, so that no product comes near 2^64.
    deformed_ += std::min(vertices, limit + 1) * std::min(times, limit + 1);
    if (deformed_ > limit)
        context_.fail("/meshes",
                      "more than " + std::to_string(limit) + " vertices of skins and morph targets; the limit is that");
}

}  // namespace kd
