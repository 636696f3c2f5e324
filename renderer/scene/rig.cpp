#include "renderer/scene/rig.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

namespace kd {

namespace {

glm::dmat4 local_matrix(const RigNode& node) {
    if (node.matrix) return *node.matrix;
    return glm::scale(glm::translate(glm::dmat4(1.0), node.translation) * glm::mat4_cast(node.rotation), node.scale);
}

void move(RigNode& node, const RigChannel& channel, double seconds) {
    if (channel.path == RigPath::weights) return;
    node.matrix.reset();
    if (channel.path == RigPath::rotation) {
        node.rotation = channel.keys.rotation_at(seconds);
        return;
    }
    const std::vector<double> value = channel.keys.at(seconds);
    (channel.path == RigPath::scale ? node.scale : node.translation) = {value[0], value[1], value[2]};
}

}  // namespace

RigMotion::RigMotion(Rig rig) : rig_(std::move(rig)) {
    for (const RigChannel& channel : rig_.channels) duration_ = std::max(duration_, double(channel.keys.times.back()));
}

std::vector<glm::dmat4> RigMotion::to_world(double seconds) const {
    std::vector<RigNode> nodes = rig_.nodes;
    for (const RigChannel& channel : rig_.channels) move(nodes[channel.node], channel, seconds);
    std::vector<glm::dmat4> world(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const glm::dmat4 local = local_matrix(nodes[i]);
        world[i] = nodes[i].parent < 0 ? local : world[std::size_t(nodes[i].parent)] * local;
    }
    return world;
}

std::vector<double> RigMotion::weights_of(const RigMesh& mesh, double seconds) const {
    std::vector<double> weights = mesh.weights;
    for (const RigChannel& channel : rig_.channels)
        if (channel.path == RigPath::weights && channel.node == mesh.node) weights = channel.keys.at(seconds);
    return weights;
}

std::vector<glm::dmat4> RigMotion::joint_matrices(const RigSkin& skin, const std::vector<glm::dmat4>& world) const {
    std::vector<glm::dmat4> matrices(skin.joints.size());
    for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] = world[skin.joints[i]] * skin.inverse_bind[i];
    return matrices;
}

void RigMotion::pose(Scene& scene, double seconds) const {
    const std::vector<glm::dmat4> world = to_world(seconds);
    for (std::size_t i = 0; i < rig_.node_of_instance.size(); ++i)
        scene.instances[i].to_world = glm::mat4(world[rig_.node_of_instance[i]]);
    for (const RigMesh& mesh : rig_.meshes) {
        std::vector<glm::dmat4> matrices;
        if (mesh.skin >= 0) {
            matrices = joint_matrices(rig_.skins[std::size_t(mesh.skin)], world);
            scene.instances[mesh.instance].to_world = glm::mat4(1.0f);  // joints place it, not its node
        }
        mesh.rest.apply(weights_of(mesh, seconds), matrices, scene.meshes[mesh.mesh]);
    }
}

}  // namespace kd
