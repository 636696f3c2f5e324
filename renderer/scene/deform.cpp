#include "renderer/scene/deform.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "renderer/geometry/cofactors.h"

namespace kd {

namespace {

glm::dvec3 turned_normal(const glm::dmat3& m, glm::dvec3 normal) {
    const glm::dmat3 of_m = cofactors(m);
    const glm::dvec3 turned = handedness(m, of_m) * (of_m * normal);
    const double length = glm::length(turned);
    return length > 0.0 ? turned / length : normal;
}

void add(const std::vector<Vec3>& from, double weight, std::vector<Vec3>& to) {
    const std::size_t count = std::min(from.size(), to.size());
    for (std::size_t i = 0; i < count; ++i) to[i] = Vec3(glm::dvec3(to[i]) + weight * glm::dvec3(from[i]));
}

}  // namespace

void Deformable::apply(std::span<const double> weights, std::span<const glm::dmat4> matrices, Mesh& mesh) const {
    mesh.positions = positions;
    mesh.normals = normals;
    add_targets(weights, mesh);
    if (!first.empty()) skin(matrices, mesh);
}

void Deformable::add_targets(std::span<const double> weights, Mesh& mesh) const {
    for (std::size_t i = 0; i < std::min(weights.size(), targets.size()); ++i) {
        if (weights[i] == 0.0) continue;
        add(targets[i].positions, weights[i], mesh.positions);
        add(targets[i].normals, weights[i], mesh.normals);
    }
}

void Deformable::skin(std::span<const glm::dmat4> matrices, Mesh& mesh) const {
    for (std::size_t vertex = 0; vertex + 1 < first.size(); ++vertex) {
        glm::dmat4 matrix(0.0);
        double sum = 0.0;
        for (std::size_t i = first[vertex]; i < first[vertex + 1]; ++i) {
            matrix += double(joints[i].weight) * matrices[joints[i].joint];
            sum += double(joints[i].weight);
        }
        if (!(sum > 0.0)) continue;
        matrix /= sum;
        mesh.positions[vertex] = Vec3(glm::dvec3(matrix * glm::dvec4(mesh.positions[vertex], 1.0)));
        if (!mesh.normals.empty())
            mesh.normals[vertex] = Vec3(turned_normal(glm::dmat3(matrix), glm::dvec3(mesh.normals[vertex])));
    }
}

}  // namespace kd
