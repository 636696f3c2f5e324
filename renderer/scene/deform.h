// Meshes whose vertices move against each other: morph targets, then a skin (glTF 2.0, sections 3.7.2.2 and 3.7.3).
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace kd {

/// What a weight of 1 adds to a mesh. Both are empty or one per vertex.
struct MorphTarget {
    std::vector<Vec3> positions, normals;
};

/// Which joints move a vertex, and how much.
struct JointWeight {
    std::uint32_t joint = 0;
    float weight = 0.0f;  // above 0
};

/// A mesh as it is made, and what moves it.
struct Deformable {
    std::vector<Vec3> positions, normals;  // normals: empty or one per position
    std::vector<MorphTarget> targets;
    std::vector<JointWeight> joints;  // of all vertices, one after the other; empty without a skin
    std::vector<std::size_t> first;   // where each vertex's begin, and the end; empty without a skin

    /// Moves `mesh`: by the targets' weights, of which missing ones are 0, then by a matrix for each joint, of which
    /// there may be none. Weights of joints are divided by their sum; a vertex without any stays where it is.
    void apply(std::span<const double> weights, std::span<const glm::dmat4> matrices, Mesh& mesh) const;

  private:
    void add_targets(std::span<const double> weights, Mesh& mesh) const;
    void skin(std::span<const glm::dmat4> matrices, Mesh& mesh) const;
};

}  // namespace kd
