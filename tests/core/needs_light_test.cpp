// What sampled light calls for, and what of it a scene does without.

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "renderer/scene/needs.h"
#include "renderer/scene/parts.h"

namespace kd {
namespace {

/// A triangle of one material under one light.
FlatScene scene_with(const Material& material, float light_radius) {
    FlatScene flat;
    flat.materials = {material};
    flat.triangles.push_back({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
    flat.attributes.emplace_back();
    flat.lights.push_back(point_light(Vec3(1.0f), Vec3(1.0f), {1.0f, 0.0f}, light_radius));
    return flat;
}

Material mirror(float roughness) {
    Material material = matte(Vec3(0.5f));
    material.reflectance = Vec3(0.5f);
    material.roughness = roughness;
    return material;
}

constexpr TraceConfig sampled{.sampling = {.sample = 0}};

bool in_use(Feature feature, const FlatScene& scene, const TraceConfig& config) {
    return scene_needs(scene, KdTree{}, config).*info(feature).in_use;
}

FeatureNeed need_of(Feature feature, const FlatScene& scene, const TraceConfig& config) {
    return info(feature).need(scene_facts(scene, KdTree{}), config);
}

TEST(NeedsOfLight, NothingIsSampledUnlessAskedFor) {
    const FlatScene everything = scene_with(mirror(0.3f), 0.2f);
    for (const Feature feature : {Feature::soft_shadows, Feature::gloss, Feature::indirect}) {
        EXPECT_FALSE(in_use(feature, everything, {})) << info(feature).name;
        EXPECT_EQ(need_of(feature, everything, {}).why, "light is not sampled");
        EXPECT_FALSE(need_of(feature, everything, {}).can_return) << "the picture would be another";
        EXPECT_TRUE(in_use(feature, everything, sampled)) << info(feature).name;
    }
}

TEST(NeedsOfLight, WhatIsSwitchedOffIsRefused) {
    const FlatScene everything = scene_with(mirror(0.3f), 0.2f);
    const std::pair<Feature, bool Sampling::*> effects[]{{Feature::soft_shadows, &Sampling::soft_shadows},
                                                         {Feature::gloss, &Sampling::gloss},
                                                         {Feature::indirect, &Sampling::indirect}};
    for (const auto& [feature, effect] : effects) {
        TraceConfig without = sampled;
        without.sampling.*effect = false;
        EXPECT_FALSE(in_use(feature, everything, without)) << info(feature).name;
        EXPECT_EQ(need_of(feature, everything, without).why, "switched off");
        EXPECT_FALSE(need_of(feature, everything, without).can_return);
    }
}

TEST(NeedsOfLight, PointsHaveNoSoftShadows) {
    const FlatScene point = scene_with(matte(Vec3(0.5f)), 0.0f);
    EXPECT_FALSE(in_use(Feature::soft_shadows, point, sampled));
    EXPECT_TRUE(need_of(Feature::soft_shadows, point, sampled).can_return);
    EXPECT_TRUE(in_use(Feature::soft_shadows, scene_with(matte(Vec3(0.5f)), 0.1f), sampled));
}

TEST(NeedsOfLight, OnlyRoughMirrorsHaveGloss) {
    EXPECT_FALSE(in_use(Feature::gloss, scene_with(mirror(0.0f), 0.1f), sampled));
    EXPECT_TRUE(in_use(Feature::gloss, scene_with(mirror(0.1f), 0.1f), sampled));
    Material rough = matte(Vec3(0.5f));
    rough.roughness = 0.5f;
    EXPECT_EQ(need_of(Feature::gloss, scene_with(rough, 0.1f), sampled).why, "nothing is reflected");
    TraceConfig without_mirrors = sampled;
    without_mirrors.reflection_depth = 0;
    EXPECT_FALSE(in_use(Feature::gloss, scene_with(mirror(0.1f), 0.1f), without_mirrors));
}

TEST(NeedsOfLight, BlackSurfacesScatterNothing) {
    Material black = matte(Vec3(0.0f));
    EXPECT_FALSE(in_use(Feature::indirect, scene_with(black, 0.1f), sampled));
    EXPECT_TRUE(need_of(Feature::indirect, scene_with(black, 0.1f), sampled).can_return);
    black.diffuse = Vec3(0, 0, 0.01f);
    EXPECT_TRUE(in_use(Feature::indirect, scene_with(black, 0.1f), sampled));
}

TEST(NeedsDocument, HasEveryFeatureByItsName) {
    std::ifstream file(std::string(KD_SOURCE_DIR) + "/docs/needs.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(text.empty());
    for (const FeatureInfo& feature : features())
        EXPECT_NE(text.find("`" + std::string(feature.name) + "`"), std::string::npos) << feature.name;
}

}  // namespace
}  // namespace kd
