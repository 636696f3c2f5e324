// Scenes of any size: kept scaled by an exact power of two, and back.

#include "renderer/scene/units.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/scene/stress_shapes.h"

namespace kd {
namespace {

Hit nearest(const FlatScene& flat, const Ray& ray) {
    const KdTree no_tree;
    TraceConfig config;
    config.traversal = Traversal::naive;
    Hit hit{};
    CpuTracer(flat, no_tree).trace_rays(config, {&ray, 1}, false, {&hit, 1}, {}, 1);
    return hit;
}

Scene triangle_scene(float size) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    return scene;
}

TEST(Units, UsualScenesStayAsTheyAre) {
    for (const float size : {0x1p-16f, 1.0f, 1000.0f, 0x1p16f}) EXPECT_EQ(flatten(triangle_scene(size)).exponent, 0);
    EXPECT_EQ(exponent_for(0.0f), 0);
}

TEST(Units, OthersAreBroughtToHalfToOneExactly) {
    for (const float size : {0x1.8p-17f, 1e-20f, 1e-42f, 0x1.8p16f, 1e18f}) {
        const FlatScene flat = flatten(triangle_scene(size));
        ASSERT_EQ(flat.triangles.size(), 1u);
        EXPECT_GE(flat.bounds.upper.x, 0.5f);
        EXPECT_LT(flat.bounds.upper.x, 1.0f);
        EXPECT_EQ(std::ldexp(flat.triangles[0].corner[1].x, flat.exponent), size);
    }
}

TEST(Units, RaysAndHitsGoThereAndBack) {
    const FlatScene flat = flatten(triangle_scene(1e-20f));
    const Ray asked{{1e-21f, 1e-21f, 5e-20f}, {0, 0, -1}, 0, 1, -1};
    const Hit hit = to_scene_units(flat, nearest(flat, to_internal(flat, asked)));
    EXPECT_EQ(hit.triangle, 0);
    EXPECT_FLOAT_EQ(hit.t, 5e-20f);
}

TEST(Units, ATriangleTooSmallForItsSceneIsDroppedAndTold) {
    Scene scene = triangle_scene(1.0f);
    Mesh speck;
    speck.positions = {{0, 0, 0}, {1e-17f, 0, 0}, {0, 1e-17f, 0}};
    speck.indices = {0, 1, 2};
    scene.meshes.push_back(speck);
    scene.instances.push_back({1});
    const FlatScene flat = flatten(scene);
    EXPECT_EQ(flat.triangles.size(), 1u);
    const auto told = [](const std::string& note) { return note.starts_with("dropped 1 triangle too small"); };
    EXPECT_TRUE(std::ranges::any_of(flat.notes, told));
}

TEST(ThinTriangles, AreHitWhereTheRayPasses) {
    // In single precision its edge functions keep no digit: without the lost ones t would be anywhere along it.
    const FlatScene flat = bare_scene({{{Vec3(0.3f, 0.2f, 0.1f), Vec3(0.9f, 0.7f, 0.8f), Vec3(0.3f, 0.20001f, 0.1f)}}});
    int hits = 0;
    for (int i = 1; i < 1000; ++i) {
        const auto& [a, b, c] = flat.triangles[0].corner;
        const Vec3 target = glm::mix(0.5f * (a + c), b, float(i) / 1000), eye(2, -1, 3);
        const Hit hit = nearest(flat, Ray{eye, target - eye, 0, KD_T_LIMIT, -1});
        if (hit.triangle < 0) continue;
        ++hits;
        EXPECT_NEAR(hit.t, 1.0f, 1e-5f);
    }
    EXPECT_GT(hits, 10);
}

}  // namespace
}  // namespace kd
