// Animations, skins and morph targets of glTF files, and what is said of those that cannot be used.

#include <gtest/gtest.h>
#include <limits>

#include "renderer/scene/motion.h"
#include "renderer/scene/moving_scene.h"
#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

using Floats = std::vector<float>;

std::size_t add_floats(GltfBuilder& builder, const Floats& values) {
    return builder.add_accessor(values, "SCALAR", 5126, values.size());
}

/// One animation of one channel: `path` of node 0 by these keys.
void animate(GltfBuilder& builder, const char* path, const Floats& times, const Floats& values, const char* type,
             const char* interpolation = "LINEAR") {
    const std::size_t width = std::string(type) == "SCALAR" ? 1 : std::string(type) == "VEC3" ? 3 : 4;
    const std::size_t input = add_floats(builder, times);
    const std::size_t output = builder.add_accessor(values, type, 5126, values.size() / width);
    builder.json["animations"].push_back(
        {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
}

/// The triangle's corners at a time; (0,0,0), (1,0,0), (0,1,0) where nothing moves.
Triangle triangle_at(const Scene& scene, double time) { return MovingScene(scene).at(time).triangles.at(0); }

/// A triangle hung by two joints: the first two corners by one at the origin, the last by one at y = 1.
template <class Number>
GltfBuilder skinned_triangle(int joint_type) {
    GltfBuilder builder = one_triangle();
    const std::vector<Number> joints{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    const Floats weights{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = builder.add_accessor(joints, "VEC4", joint_type, 3);
    attributes["WEIGHTS_0"] = builder.add_accessor(weights, "VEC4", 5126, 3);
    Floats bind;
    for (const float y : {0.0f, -1.0f})
        for (const float value : {1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, y, 0.f, 1.f})
            bind.push_back(value);
    builder.json["skins"] = {
        {{"joints", {1, 2}}, {"inverseBindMatrices", builder.add_accessor(bind, "MAT4", 5126, 2)}}};
    auto& nodes = builder.json["nodes"];
    nodes[0]["skin"] = 0;
    nodes[0]["translation"] = {50, 50, 50};  // which a skinned mesh ignores
    nodes.push_back({{"children", {2}}});
    nodes.push_back({{"translation", {0, 1, 0}}, {"scale", {2, 2, 2}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    return builder;
}

TEST(GltfAnimation, MovesANode) {
    GltfBuilder builder = one_triangle();
    animate(builder, "translation", {0, 2}, {1, 0, 0, 3, 0, 0}, "VEC3");
    const Scene scene = load(builder);
    ASSERT_TRUE(scene.motion);
    EXPECT_EQ(scene.motion->duration(), 2.0);
    EXPECT_EQ(triangle_at(scene, 0).corner[0], Vec3(1, 0, 0)) << "at rest it is as at 0 s, not as without animation";
    EXPECT_EQ(triangle_at(scene, 0.5).corner[0], Vec3(1.5f, 0, 0));
    EXPECT_EQ(triangle_at(scene, 2.5).corner[0], Vec3(1.5f, 0, 0)) << "it repeats";
    EXPECT_TRUE(scene.notes.empty()) << ::testing::PrintToString(scene.notes);
}

TEST(GltfAnimation, WhatNoChannelMovesStays) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["translation"] = {0, 0, 7};
    animate(builder, "scale", {0, 1}, {1, 1, 1, 3, 1, 1}, "VEC3", "STEP");
    const Scene scene = load(builder);
    EXPECT_EQ(triangle_at(scene, 0.9).corner[1], Vec3(1, 0, 7));
    EXPECT_EQ(scene.motion->duration(), 1.0);
}

TEST(GltfAnimation, AllPlayTogetherForAsLongAsTheLongest) {
    GltfBuilder builder = one_triangle();
    animate(builder, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3");
    animate(builder, "scale", {0, 4}, {1, 1, 1, 5, 1, 1}, "VEC3");
    const Scene scene = load(builder);
    EXPECT_EQ(scene.motion->duration(), 4.0);
    EXPECT_EQ(triangle_at(scene, 2).corner[1], Vec3(4, 0, 0)) << "1 where the translation ended, and 3 times 1";
}

TEST(GltfAnimation, TurnsANode) {
    GltfBuilder builder = one_triangle();
    const float half = 0.70710678f;
    animate(builder, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, half, half}, "VEC4");
    const Vec3 corner = triangle_at(load(builder), 0.5).corner[1];
    EXPECT_NEAR(corner.x, half, 1e-6f);
    EXPECT_NEAR(corner.y, half, 1e-6f);
}

TEST(GltfMorph, DefaultWeightsOfMeshAndNode) {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", builder.add_vec3({{0, 0, 2}, {0, 0, 0}, {0, 0, 0}})}}};
    EXPECT_EQ(triangle_at(load(builder), 0).corner[0], Vec3(0, 0, 0));
    builder.json["meshes"][0]["weights"] = {0.5};
    EXPECT_EQ(triangle_at(load(builder), 0).corner[0], Vec3(0, 0, 1));
    builder.json["nodes"][0]["weights"] = {2};
    const Scene scene = load(builder);
    EXPECT_EQ(triangle_at(scene, 0).corner[0], Vec3(0, 0, 4));
    EXPECT_FALSE(scene.motion) << "one pose is no motion";
    EXPECT_TRUE(scene.notes.empty()) << ::testing::PrintToString(scene.notes);
}

TEST(GltfMorph, WeightsMove) {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", builder.add_vec3({{0, 0, 2}, {0, 0, 0}, {0, 0, 0}})}},
        {{"POSITION", builder.add_vec3({{0, 4, 0}, {0, 0, 0}, {0, 0, 0}})}}};
    animate(builder, "weights", {0, 1}, {0, 0, 1, 0.5f}, "SCALAR");
    EXPECT_EQ(triangle_at(load(builder), 0.5).corner[0], Vec3(0, 1, 1));
}

TEST(GltfSkin, JointsPlaceTheMesh) {
    for (const GltfBuilder& builder : {skinned_triangle<std::uint8_t>(5121), skinned_triangle<std::uint16_t>(5123)}) {
        const Triangle triangle = triangle_at(load(builder), 0);
        EXPECT_EQ(triangle.corner[1], Vec3(1, 0, 0));
        EXPECT_EQ(triangle.corner[2], Vec3(0, 1, 0)) << "the joint's own place, which its scale does not move";
    }
}

TEST(GltfSkin, AMeshShownTwiceIsDeformedForEach) {
    GltfBuilder builder = skinned_triangle<std::uint8_t>(5121);
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 9}}});
    builder.json["scenes"][0]["nodes"].push_back(3);
    const FlatScene flat = flatten(load(builder));
    ASSERT_EQ(flat.triangles.size(), 2u);
    EXPECT_EQ(flat.triangles[0].corner[0], Vec3(0, 0, 0));
    EXPECT_EQ(flat.triangles[1].corner[0], Vec3(0, 0, 9)) << "without a skin it stands at its node";
}

TEST(GltfSkin, JointsThatItLacksAreIgnored) {
    GltfBuilder builder = skinned_triangle<std::uint8_t>(5121);
    builder.json["skins"] = {{{"joints", {1}}}};
    const Scene scene = load(builder);
    EXPECT_TRUE(has_note(scene, "ignored 1 joint weight, negative or of one that the skin lacks"));
    EXPECT_TRUE(has_note(scene, "left 1 position without joint weights where the mesh has it"));
    EXPECT_EQ(triangle_at(scene, 0).corner[2], Vec3(0, 1, 0));
}

TEST(GltfSkin, UnusableOnesAreIgnored) {
    GltfBuilder outside = skinned_triangle<std::uint8_t>(5121);
    outside.json["scenes"][0]["nodes"] = {0};
    EXPECT_TRUE(has_note(load(outside), "ignored 1 skin with joints outside of the scene"));
    GltfBuilder few = skinned_triangle<std::uint8_t>(5121);
    few.json["accessors"].back()["count"] = 1;
    EXPECT_TRUE(has_note(load(few), "ignored 1 skin whose inverse bind matrices do not go with its joints"));
}

TEST(GltfAnimation, UnusableChannelsAreCounted) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto told = [](const Floats& times, const Floats& values, const char* path, const char* type,
                         const char* how) {
        GltfBuilder builder = one_triangle();
        animate(builder, path, times, values, type, how);
        const Scene scene = load(builder);
        EXPECT_FALSE(scene.motion);
        return scene.notes.empty() ? "" : scene.notes.front();
    };
    const Floats two{0, 0, 0, 1, 1, 1};
    const std::string ascend = "ignored 1 animation channel, whose times do not ascend from 0 on";
    EXPECT_EQ(told({1, 0}, two, "translation", "VEC3", "LINEAR"), ascend);
    EXPECT_EQ(told({1, 1}, two, "translation", "VEC3", "LINEAR"), ascend);
    EXPECT_EQ(told({0, nan}, two, "translation", "VEC3", "LINEAR"), ascend);
    EXPECT_EQ(told({-1, 0}, two, "translation", "VEC3", "LINEAR"), ascend);
    EXPECT_EQ(told({0, 1}, {0, 0, 0, nan, 1, 1}, "translation", "VEC3", "LINEAR"),
              "ignored 1 animation channel, whose values are not finite");
    const std::string unfit = "ignored 1 animation channel, whose values do not go with their times";
    EXPECT_EQ(told({0, 1, 2}, two, "translation", "VEC3", "LINEAR"), unfit);
    EXPECT_EQ(told({0, 1}, two, "translation", "VEC3", "CUBICSPLINE"), unfit);
    EXPECT_EQ(told({0, 1}, two, "rotation", "VEC3", "LINEAR"), unfit);
    EXPECT_EQ(told({0, 1}, two, "translation", "VEC3", "SMOOTH"),
              "ignored 1 animation channel, whose interpolation is unknown");
    EXPECT_EQ(told({0, 1}, two, "pointer", "VEC3", "LINEAR"),
              "ignored 1 animation channel, which move what glTF 2.0 does not name");
}

TEST(GltfAnimation, NumbersThatPointNowhereAreRefused) {
    const auto refused = [](auto change) {
        GltfBuilder builder = skinned_triangle<std::uint8_t>(5121);
        animate(builder, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, "VEC3");
        change(builder.json);
        return load_error(builder.text());
    };
    EXPECT_EQ(refused([](auto& json) { json["skins"][0]["joints"][0] = 9; }),
              "scene.gltf: /skins/0/joints/0: 9 is not one of the 3 nodes");
    EXPECT_EQ(refused([](auto& json) { json["nodes"][0]["skin"] = 1; }),
              "scene.gltf: /nodes/0/skin: 1 is not one of the 1 skins");
    EXPECT_EQ(refused([](auto& json) { json["animations"][0]["samplers"][0]["input"] = 99; }).substr(0, 53),
              "scene.gltf: /animations/0/samplers/0/input: 99 is not");
    EXPECT_EQ(refused([](auto& json) { json["animations"][0]["channels"][0].erase("target"); }),
              "scene.gltf: /animations/0/channels/0/target: missing");
}

TEST(GltfAnimation, LimitsHoldBeforeMemoryIsTaken) {
    const auto refused = [](const GltfBuilder& builder, const GltfLimits& limits) {
        return error_of([&] { (void)decode_gltf(builder.text(), "scene.gltf", limits); });
    };
    GltfBuilder animated = one_triangle();
    animate(animated, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, "VEC3");
    EXPECT_EQ(refused(animated, {.key_values = 8}), "");
    EXPECT_NE(refused(animated, {.key_values = 7}).find("more than 7 values of key frames"), std::string::npos);
    const GltfBuilder skinned = skinned_triangle<std::uint8_t>(5121);
    EXPECT_EQ(refused(skinned, {.deformed = 6}), "");
    EXPECT_NE(refused(skinned, {.deformed = 5}).find("more than 5 vertices"), std::string::npos);
}

}  // namespace
}  // namespace kd
