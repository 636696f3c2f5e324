// What scenes and settings call for, and the lines that tell what is left out.

#include "renderer/scene/needs.h"

#include <gtest/gtest.h>

#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

/// A triangle of each material but the last, which nothing uses.
FlatScene with_materials(const std::vector<Material>& materials) {
    FlatScene flat;
    flat.materials = materials;
    for (std::size_t i = 0; i + 1 < materials.size(); ++i) {
        flat.triangles.push_back({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
        flat.attributes.emplace_back().material = int(i);
    }
    flat.lights.push_back(point_light(Vec3(1.0f), Vec3(1.0f)));
    return flat;
}

Material mirror(Vec3 reflectance) {
    Material material = matte(Vec3(0.5f));
    material.reflectance = reflectance;
    return material;
}

Material textured() {
    Material material = matte(Vec3(0.5f));
    material.texture = 0;
    return material;
}

std::vector<std::string> lines(const FlatScene& scene, const TraceConfig& config = {}) {
    return left_out(scene_needs(scene, config), scene, config);
}

TEST(SceneNeeds, PlainSceneNeedsShadowsOnly) {
    const FlatScene flat = with_materials({matte(Vec3(0.5f)), matte(Vec3(0.5f))});
    EXPECT_EQ(scene_needs(flat, {}), (SceneNeeds{.shadows = true}));
    EXPECT_EQ(lines(flat), (std::vector<std::string>{"RTRefl, ShadeRefl: no reflective material",
                                                     "texture fetch: no textured material",
                                                     "interpolated normals: all normals are flat"}));
}

TEST(SceneNeeds, OnlyUsedMaterialsCount) {
    const FlatScene unused = with_materials({matte(Vec3(0.5f)), mirror(Vec3(0.5f))});
    EXPECT_FALSE(scene_needs(unused, {}).reflections);
    EXPECT_FALSE(scene_needs(with_materials({matte(Vec3(0.5f)), textured()}), {}).textures);

    const FlatScene used = with_materials({mirror(Vec3(0.5f)), textured(), matte(Vec3(0.5f))});
    EXPECT_EQ(scene_needs(used, {}),
              (SceneNeeds{.textures = true, .shadows = true, .reflections = true, .bounces = 1}));
    EXPECT_EQ(lines(used), std::vector<std::string>{"interpolated normals: all normals are flat"});
}

TEST(SceneNeeds, OneChannelOfReflectanceIsEnough) {
    EXPECT_TRUE(scene_needs(with_materials({mirror({0, 0, 0.3f}), matte(Vec3(1.0f))}), {}).reflections);
}

TEST(SceneNeeds, ReflectanceBelowTheLeastContributionIsLeftOut) {
    const FlatScene flat = with_materials({mirror(Vec3(0.25f)), matte(Vec3(1.0f))});
    EXPECT_TRUE(scene_needs(flat, {.least_contribution = 0.25f}).reflections) << "equal counts, as in the passes";
    EXPECT_FALSE(scene_needs(flat, {.least_contribution = 0.26f}).reflections);
    EXPECT_EQ(lines(flat, {.least_contribution = 0.26f})[0],
              "RTRefl, ShadeRefl: no material reflects as much as the least contribution of 0.26");
    // With no least contribution a black mirror still reflects nothing.
    const FlatScene black = with_materials({mirror(Vec3(0.0f)), matte(Vec3(1.0f))});
    EXPECT_FALSE(scene_needs(black, {.least_contribution = 0.0f}).reflections);
}

TEST(SceneNeeds, DepthZeroSwitchesReflectionOff) {
    const FlatScene flat = with_materials({mirror(Vec3(0.5f)), matte(Vec3(1.0f))});
    EXPECT_EQ(scene_needs(flat, {.reflection_depth = 0}).bounces, 0);
    EXPECT_EQ(lines(flat, {.reflection_depth = 0})[0], "RTRefl, ShadeRefl: switched off");
}

TEST(SceneNeeds, BouncesEndWhereNoPathCanCount) {
    const FlatScene flat = with_materials({mirror(Vec3(0.25f)), mirror({0.5f, 0, 0}), mirror(Vec3(1.0f))});
    // 0.5, 0.25, 0.125 count against 0.1; 0.0625 does not.
    const TraceConfig config{.reflection_depth = 8, .least_contribution = 0.1f};
    EXPECT_EQ(scene_needs(flat, config).bounces, 3);
    EXPECT_EQ(lines(flat, config)[0],
              "RTRefl, ShadeRefl after bounce 3: no path can still reach the least contribution of 0.1");
    EXPECT_EQ(scene_needs(flat, {.reflection_depth = 2, .least_contribution = 0.1f}).bounces, 2);
    const FlatScene perfect = with_materials({mirror(Vec3(1.0f)), matte(Vec3(1.0f))});
    EXPECT_EQ(scene_needs(perfect, {.reflection_depth = 100}).bounces, 100);
}

TEST(SceneNeeds, ShadowsNeedALightAndTheSwitch) {
    FlatScene flat = with_materials({matte(Vec3(0.5f)), matte(Vec3(0.5f))});
    EXPECT_FALSE(scene_needs(flat, {.shadows = false}).shadows);
    EXPECT_EQ(lines(flat, {.shadows = false}).back(), "shadow rays: switched off");
    flat.lights.clear();
    EXPECT_FALSE(scene_needs(flat, {}).shadows);
    EXPECT_EQ(lines(flat).back(), "shadow rays: no light");
}

TEST(SceneNeeds, OfTheProceduralScenes) {
    const auto needs = [](const char* name) { return scene_needs(flatten(make_procedural(name).value()), {}); };
    EXPECT_EQ(needs("ball:1000"), (SceneNeeds{.normals = true, .shadows = true, .reflections = true, .bounces = 1}));
    EXPECT_EQ(needs("icoball:1000"), needs("ball:1000"));
    EXPECT_EQ(needs("rooms"), (SceneNeeds{.shadows = true}));
    EXPECT_EQ(needs("scatter:100"), (SceneNeeds{.shadows = true}));
    EXPECT_EQ(needs("sheet:100"), (SceneNeeds{.textures = true, .normals = true, .shadows = true}));
    EXPECT_EQ(needs("cornell"), (SceneNeeds{.shadows = true, .reflections = true, .bounces = 1}));
}

}  // namespace
}  // namespace kd
