// Key frames, morph targets and skins, with values worked out by hand.

#include "renderer/scene/rig.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

namespace kd {
namespace {

using Numbers = std::vector<double>;

TEST(Keyframes, StepsHoldUntilTheNext) {
    const Keyframes keys{Interpolation::step, 1, {1, 2, 4}, {10, 20, 40}};
    EXPECT_EQ(keys.at(0), Numbers{10}) << "before the first key it holds";
    EXPECT_EQ(keys.at(1.999), Numbers{10});
    EXPECT_EQ(keys.at(2), Numbers{20});
    EXPECT_EQ(keys.at(3.9), Numbers{20});
    EXPECT_EQ(keys.at(99), Numbers{40});
}

TEST(Keyframes, LinearOnesGoStraight) {
    const Keyframes keys{Interpolation::linear, 2, {1, 2, 4}, {10, -1, 20, 1, 40, 1}};
    EXPECT_EQ(keys.at(1.5), (Numbers{15, 0}));
    EXPECT_EQ(keys.at(3), (Numbers{30, 1}));
    EXPECT_EQ(keys.at(0), (Numbers{10, -1}));
    EXPECT_EQ(keys.at(5), (Numbers{40, 1}));
}

TEST(Keyframes, SplinesMeetKeysAndTangents) {
    // From 0 to 8 within 2 s, leaving with 4 per second and arriving with 0: at half way
    // 0.5 * 0 + 2 * 0.125 * 4 + 0.5 * 8 + 2 * -0.125 * 0 = 5.
    const Keyframes keys{Interpolation::cubic_spline, 1, {1, 3}, {7, 0, 4, 0, 8, 7}};
    EXPECT_EQ(keys.at(1), Numbers{0});
    EXPECT_EQ(keys.at(2), Numbers{5});
    EXPECT_EQ(keys.at(3), Numbers{8});
    EXPECT_EQ(keys.at(9), Numbers{8});
    EXPECT_NEAR((keys.at(1 + 1e-6)[0] - keys.at(1)[0]) / 1e-6, 4.0, 1e-4);
}

TEST(Keyframes, RotationsTurnEvenlyAlongTheShorterArc) {
    // From none to a right angle about z, given by the negative quaternion, which is the same turn.
    const float half = std::numbers::sqrt2_v<float> / 2;
    const Keyframes keys{Interpolation::linear, 4, {0, 3}, {0, 0, 0, 1, 0, 0, -half, -half}};
    const glm::dquat third = keys.rotation_at(1.0);
    const double angle = std::numbers::pi / 6;  // a third of 90 degrees
    // 1e-7: the keys are floats.
    EXPECT_NEAR(std::abs(third.w), std::cos(angle / 2), 1e-7);
    EXPECT_NEAR(std::abs(third.z), std::sin(angle / 2), 1e-7);
    EXPECT_GT(third.w * third.z, 0.0);
}

TEST(Keyframes, RotationsAreOfUnitLength) {
    const Keyframes none{Interpolation::step, 4, {0}, {0, 0, 0, 0}};
    EXPECT_EQ(none.rotation_at(0), glm::dquat(1.0, 0.0, 0.0, 0.0));
    const Keyframes spline{Interpolation::cubic_spline, 4, {0, 1}, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 3, 0,  //
                                                                    0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}};
    EXPECT_NEAR(glm::length(spline.rotation_at(0.3)), 1.0, 1e-15);
}

Deformable two_points() {
    Deformable rest;
    rest.positions = {{1, 0, 0}, {0, 1, 0}};
    rest.normals = {{1, 0, 0}, {0, 1, 0}};
    return rest;
}

TEST(Deformable, TargetsAddUpByTheirWeights) {
    Deformable rest = two_points();
    rest.targets = {{{{1, 0, 0}, {0, 0, 2}}, {}}, {{{0, 8, 0}, {0, 0, 0}}, {{0, 1, 0}, {0, 0, 0}}}};
    Mesh mesh;
    rest.apply(Numbers{0.5, 0.25}, {}, mesh);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{1.5f, 2, 0}, {0, 1, 1}}));
    EXPECT_EQ(mesh.normals, (std::vector<Vec3>{{1, 0.25f, 0}, {0, 1, 0}}));
    rest.apply(Numbers{}, {}, mesh);
    EXPECT_EQ(mesh.positions, rest.positions) << "it begins at rest each time";
}

TEST(Deformable, JointsMixTheirMatrices) {
    Deformable rest = two_points();
    rest.joints = {{0, 0.25f}, {1, 0.75f}, {1, 2.0f}};
    rest.first = {0, 2, 3};
    const std::vector<glm::dmat4> joints{glm::translate(glm::dmat4(1.0), {4.0, 0.0, 0.0}),
                                         glm::scale(glm::dmat4(1.0), {1.0, 2.0, 1.0})};
    Mesh mesh;
    rest.apply({}, joints, mesh);
    EXPECT_EQ(mesh.positions[0], Vec3(2, 0, 0)) << "0.25 (1 + 4) + 0.75 * 1";
    EXPECT_EQ(mesh.positions[1], Vec3(0, 2, 0)) << "weights are divided by their sum";
}

TEST(Deformable, NormalsGoByTheInverseTranspose) {
    Deformable rest = two_points();
    rest.normals[0] = glm::normalize(Vec3(1, 1, 0));
    rest.joints = {{0, 1.0f}};
    rest.first = {0, 1, 1};
    Mesh mesh;
    rest.apply({}, std::vector{glm::scale(glm::dmat4(1.0), {0.25, 1.0, 1.0})}, mesh);
    EXPECT_LT(glm::distance(mesh.normals[0], glm::normalize(Vec3(4, 1, 0))), 1e-6f);
    EXPECT_EQ(mesh.positions[1], Vec3(0, 1, 0)) << "a vertex without weights stays";
    rest.apply({}, std::vector{glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0})}, mesh);
    EXPECT_LT(glm::distance(mesh.normals[0], glm::normalize(Vec3(-1, 1, 0))), 1e-6f) << "a mirror image";
}

TEST(RigMotion, ChildrenFollowAndSkinnedMeshesIgnoreTheirNode) {
    // A joint, moved by 1 a second, carries an arm two units long; both points hang on the arm's end.
    Rig rig;
    rig.nodes = {{}, {.parent = 0, .translation = {0.0, 2.0, 0.0}}, {.translation = {100.0, 0.0, 0.0}}};
    rig.channels = {{0, RigPath::translation, {Interpolation::linear, 3, {0, 2}, {0, 0, 0, 2, 0, 0}}}};
    rig.skins = {{{1}, {glm::dmat4(1.0)}}};
    rig.node_of_instance = {2, 0};
    RigMesh mesh{.instance = 0, .mesh = 0, .node = 2, .skin = 0};
    mesh.rest = two_points();
    mesh.rest.joints = {{0, 1.0f}, {0, 1.0f}};
    mesh.rest.first = {0, 1, 2};
    rig.meshes = {mesh};
    const RigMotion motion(std::move(rig));
    EXPECT_EQ(motion.duration(), 2.0);
    Scene scene;
    scene.meshes.resize(2);
    scene.instances.resize(2);
    motion.pose(scene, 0.5);
    EXPECT_EQ(scene.meshes[0].positions, (std::vector<Vec3>{{1.5f, 2, 0}, {0.5f, 3, 0}}));
    EXPECT_EQ(scene.instances[0].to_world, glm::mat4(1.0f));
    EXPECT_EQ(Vec3(scene.instances[1].to_world[3]), Vec3(0.5f, 0, 0));
}

TEST(RigMotion, WeightsAreThoseOfTheirNode) {
    Rig rig;
    rig.nodes.resize(2);
    rig.channels = {{1, RigPath::weights, {Interpolation::linear, 1, {0, 1}, {0, 1}}}};
    rig.node_of_instance = {0, 1};
    for (std::size_t i = 0; i < 2; ++i) {
        RigMesh mesh{.instance = i, .mesh = i, .node = i};
        mesh.weights = {1.0};
        mesh.rest = two_points();
        mesh.rest.targets = {{{{1, 0, 0}, {1, 0, 0}}, {}}};
        rig.meshes.push_back(mesh);
    }
    const RigMotion motion(std::move(rig));
    Scene scene;
    scene.meshes.resize(2);
    scene.instances.resize(2);
    motion.pose(scene, 0.25);
    EXPECT_EQ(scene.meshes[0].positions[0], Vec3(2, 0, 0)) << "no channel: its own weight";
    EXPECT_EQ(scene.meshes[1].positions[0], Vec3(1.25f, 0, 0));
}

}  // namespace
}  // namespace kd
