// A hierarchy of nodes that moves by key frames, and the instances and meshes that it carries.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "renderer/scene/deform.h"
#include "renderer/scene/keyframes.h"
#include "renderer/scene/motion.h"

namespace kd {

/// A node's place in its parent: a matrix, or what animations move.
struct RigNode {
    int parent = -1;  // its number, less than the node's own; -1 for a root
    std::optional<glm::dmat4> matrix{};
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
};

enum class RigPath { translation, rotation, scale, weights };

/// What moves one property of a node. Later channels win over earlier ones.
struct RigChannel {
    std::size_t node = 0;
    RigPath path = RigPath::translation;
    Keyframes keys;
};

struct RigSkin {
    std::vector<std::size_t> joints;  // nodes
    std::vector<glm::dmat4> inverse_bind;
};

/// A mesh of the scene that its instance alone shows, deformed.
struct RigMesh {
    std::size_t instance = 0, mesh = 0;  // of the scene
    std::size_t node = 0;                // whose weights it takes
    int skin = -1;                       // none: it stands where its node is
    std::vector<double> weights{};       // of the morph targets, where no channel says
    Deformable rest{};
};

struct Rig {
    std::vector<RigNode> nodes;  // parents before children
    std::vector<RigChannel> channels;
    std::vector<RigSkin> skins;
    std::vector<std::size_t> node_of_instance;  // of each of the scene's instances
    std::vector<RigMesh> meshes;
};

class RigMotion : public Motion {
  public:
    explicit RigMotion(Rig rig);

    /// The last key's time; 0 where there is none later than 0: then the rig has one pose and is no motion.
    [[nodiscard]] double duration() const override { return duration_; }
    void pose(Scene& scene, double seconds) const override;

    /// From each node to the world.
    [[nodiscard]] std::vector<glm::dmat4> to_world(double seconds) const;

  private:
    [[nodiscard]] std::vector<double> weights_of(const RigMesh& mesh, double seconds) const;
    [[nodiscard]] std::vector<glm::dmat4> joint_matrices(const RigSkin& skin,
                                                         const std::vector<glm::dmat4>& world) const;

    Rig rig_;
    double duration_ = 0.0;
};

}  // namespace kd
