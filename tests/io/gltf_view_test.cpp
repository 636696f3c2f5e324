#include <cmath>
#include <numbers>

#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

using nlohmann::json;

constexpr double pi = std::numbers::pi;

/// One triangle, and a node with this light for each of `lights`.
GltfBuilder lit_by(const json& lights) {
    GltfBuilder builder = one_triangle();
    builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        builder.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    return builder;
}

TEST(GltfLight, PointLightsFallWithTheSquare) {
    GltfBuilder builder = lit_by({{{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 2}, {"range", 30}}});
    builder.json["nodes"][1]["translation"] = {1, 2, 3};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.lights.size(), 1u);
    const Light& light = scene.lights[0];
    EXPECT_EQ(light.kind, KD_LIGHT_POINT);
    EXPECT_EQ(light.position, Vec3(1, 2, 3));
    EXPECT_EQ(light.attenuation, Vec2(0, 1));
    EXPECT_EQ(light.range, 30.0f);
    EXPECT_NEAR(light.colour.x, 2 / pi, 1e-6);
    EXPECT_NEAR(light.colour.y, 2 / pi * 0.735357, 1e-5);
    EXPECT_EQ(light.colour.z, 0.0f);
    EXPECT_TRUE(scene.notes.empty());
}

TEST(GltfLight, DirectionalLightsShineAlongTheirNode) {
    GltfBuilder builder = lit_by({{{"type", "directional"}, {"intensity", pi / 2}}});
    // A quarter turn about x takes -z to +y; the scale must not matter.
    builder.json["nodes"][1]["rotation"] = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    builder.json["nodes"][1]["scale"] = {3, 3, 3};
    const Light light = load(builder).lights.at(0);
    EXPECT_EQ(light.kind, KD_LIGHT_DIRECTIONAL);
    EXPECT_NEAR(light.direction.x, 0, 1e-6);
    EXPECT_NEAR(light.direction.y, 1, 1e-6);
    EXPECT_NEAR(light.direction.z, 0, 1e-6);
    EXPECT_NEAR(light.colour.x, 0.5, 1e-6);
    EXPECT_EQ(light.range, 0.0f);
}

TEST(GltfLight, SpotsHaveTwoCones) {
    const Scene scene = load(lit_by({{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}}},
                                     {{"type", "spot"}, {"spot", json::object()}}}));
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].kind, KD_LIGHT_SPOT);
    EXPECT_NEAR(scene.lights[0].cos_inner, std::cos(0.2), 1e-6);
    EXPECT_NEAR(scene.lights[0].cos_outer, std::cos(0.6), 1e-6);
    EXPECT_EQ(scene.lights[1].cos_inner, 1.0f);
    EXPECT_NEAR(scene.lights[1].cos_outer, std::sqrt(0.5), 1e-6);
}

TEST(GltfLight, BrightLightsAreDimmedAlike) {
    const Scene scene = load(lit_by(
        {{{"type", "directional"}, {"intensity", 100 * pi}}, {{"type", "directional"}, {"intensity", 10 * pi}}}));
    EXPECT_NEAR(scene.lights.at(0).colour.x, 1.0, 1e-6);
    EXPECT_NEAR(scene.lights.at(1).colour.x, 0.1, 1e-6);
    EXPECT_TRUE(has_note(scene, "dimmed all lights by a factor of 100,"));
}

TEST(G25, UnusableLightsAreCounted) {
    GltfBuilder builder = lit_by({{{"type", "point"}, {"intensity", -1}},
                                  {{"type", "point"}, {"intensity", 0}},
                                  {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}}}},
                                  {{"type", "spot"}, {"spot", {{"outerConeAngle", 3}}}},
                                  {{"type", "area"}},
                                  {{"type", "directional"}}});
    builder.json["nodes"][6]["scale"] = {0, 0, 0};
    builder.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 77}}}}}});
    builder.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", "x"}}}}}});
    builder.json["scenes"][0]["nodes"].push_back(7);
    builder.json["scenes"][0]["nodes"].push_back(8);
    const Scene scene = load(builder);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(has_note(scene, "ignored 8 lights whose values cannot be used"));
}

TEST(G25, ManyLightsAreCapped) {
    json lights = json::array();
    for (int i = 0; i < 100; ++i) lights.push_back({{"type", "point"}});
    const Scene scene = load(lit_by(lights));
    EXPECT_EQ(scene.lights.size(), 64u);
    EXPECT_TRUE(has_note(scene, "ignored 36 lights beyond the first 64"));
}

/// One triangle seen by these cameras, each on a node of its own.
GltfBuilder seen_by(const json& cameras) {
    GltfBuilder builder = one_triangle();
    builder.json["cameras"] = cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        builder.json["nodes"].push_back({{"camera", i}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    return builder;
}

json perspective(double yfov) { return {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", 0.1}}}}; }

TEST(GltfCamera, LooksAlongItsNodeAtTheDepthOfTheScene) {
    GltfBuilder builder = seen_by(json::array({perspective(0.7)}));
    builder.json["nodes"][1]["translation"] = {0.5, 0.5, 3};
    const Scene scene = load(builder);
    ASSERT_TRUE(scene.camera.has_value());
    EXPECT_EQ(scene.camera->eye, Vec3(0.5f, 0.5f, 3));
    EXPECT_EQ(scene.camera->target, Vec3(0.5f, 0.5f, 0)) << "the triangle lies at z = 0";
    EXPECT_EQ(scene.camera->up, Vec3(0, 1, 0));
    EXPECT_NEAR(scene.camera->fov_y_degrees, 0.7 * 180 / pi, 1e-4);
}

TEST(GltfCamera, WithTheSceneBehindItStillLooksItsWay) {
    GltfBuilder builder = seen_by(json::array({perspective(0.7)}));
    builder.json["nodes"][1]["translation"] = {0, 0, -5};
    const Scene scene = load(builder);
    ASSERT_TRUE(scene.camera.has_value());
    EXPECT_LT(scene.camera->target.z, -5.0f);
}

TEST(G24, TheFirstUsableOneIsTaken) {
    const json flat = {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0.1}}}};
    const Scene scene = load(seen_by({flat, perspective(0), perspective(4), perspective(1), perspective(0.5)}));
    ASSERT_TRUE(scene.camera.has_value());
    EXPECT_NEAR(scene.camera->fov_y_degrees, 180 / pi, 1e-4);
    EXPECT_TRUE(has_note(scene, "ignored 1 camera without perspective"));
    EXPECT_TRUE(has_note(scene, "ignored 2 cameras whose angle or place cannot be used"));
}

}  // namespace
}  // namespace kd
