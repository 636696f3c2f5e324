#include "renderer/io/gltf_node.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace kd {

namespace {

glm::dmat4 rotation_of(GltfContext& context, const std::vector<double>& xyzw) {
    const glm::dquat rotation(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = glm::length(rotation);
    if (!(length > 0.0) || !std::isfinite(length)) {
        context.count("ignored", "rotation", " of length zero or beyond measure");
        return glm::dmat4(1.0);
    }
    return glm::mat4_cast(rotation / length);  // exporters round, so the length is never taken for 1
}

/// tinygltf leaves what the file does not say empty; lengths have been checked.
glm::dmat4 local_matrix(GltfContext& context, const tinygltf::Node& node) {
    glm::dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                matrix[column][row] = node.matrix[static_cast<std::size_t>(4 * column + row)];
            }
        }
        return matrix;
    }
    if (!node.translation.empty()) {
        matrix = glm::translate(matrix, {node.translation[0], node.translation[1], node.translation[2]});
    }
    if (!node.rotation.empty()) matrix = matrix * rotation_of(context, node.rotation);
    if (!node.scale.empty()) matrix = glm::scale(matrix, {node.scale[0], node.scale[1], node.scale[2]});
    return matrix;
}

std::vector<int> root_nodes(const tinygltf::Model& model) {
    if (!model.scenes.empty()) {
        return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
    }
    std::vector<char> has_parent(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) has_parent[static_cast<std::size_t>(child)] = 1;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!has_parent[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

}  // namespace

std::vector<PlacedNode> placed_nodes(GltfContext& context, const tinygltf::Model& model) {
    // Last in, first out, so children are put on in reverse.
    std::vector<PlacedNode> waiting;
    const auto put = [&](const std::vector<int>& nodes, const glm::dmat4& to_world, int parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            waiting.push_back({static_cast<std::size_t>(*node), to_world, parent, glm::dmat4(1.0)});
    };
    put(root_nodes(model), glm::dmat4(1.0), -1);

    std::vector<PlacedNode> placed;
    std::vector<char> seen(model.nodes.size(), 0);
    while (!waiting.empty()) {
        PlacedNode next = waiting.back();
        waiting.pop_back();
        if (seen[next.node]) {
            context.fail(pointer_to("/nodes", next.node),
                         "reached twice (a loop, or two parents); nodes must form trees");
        }
        seen[next.node] = 1;
        const tinygltf::Node& node = model.nodes[next.node];
        next.to_parent = local_matrix(context, node);
        next.to_world = next.to_world * next.to_parent;
        placed.push_back(next);
        put(node.children, next.to_world, static_cast<int>(placed.size()) - 1);
    }
    return placed;
}

std::vector<int> places_of(const std::vector<PlacedNode>& nodes, const tinygltf::Model& model) {
    std::vector<int> places(model.nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) places[nodes[i].node] = static_cast<int>(i);
    return places;
}

}  // namespace kd
