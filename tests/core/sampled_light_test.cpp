// Soft shadows, gloss and indirect light, against what they must be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/accumulator.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

Frame sample_of(const FlatScene& scene, const KdTree& tree, TraceConfig config, int number, int side,
                CpuMode mode = CpuMode::scalar) {
    config.sampling.sample = number;
    Frame frame(side, side);
    CpuTracer(scene, tree, mode).trace_frame(config, pinhole(scene.camera, side, side), frame, 2);
    return frame;
}

Frame picture_of(const FlatScene& scene, const TraceConfig& config, int samples, int side) {
    const KdTree tree = build_tree(scene.triangles, {});
    Accumulator gathered(side, side);
    for (int i = 0; i < samples; ++i) gathered.add(sample_of(scene, tree, config, i, side), gathered.tiles());
    return gathered.frame();
}

void add_open_box(Scene& scene, const BoxShape& shape, const Material& material) {
    Mesh mesh{.name = "box"};
    add_box(mesh, shape);
    place(scene, std::move(mesh), material);
}

/// A cube in a closed room: wherever one looks, a surface of this material.
Scene furnace(const Material& material) {
    Scene scene;
    scene.ambient = Vec3(0.0f);
    add_open_box(scene, {.lower = {-2, -2, -2}, .upper = {2, 2, 2}, .seen_from_inside = true}, material);
    add_open_box(scene, {.lower = {-0.5f, -0.5f, -0.5f}, .upper = {0.5f, 0.5f, 0.5f}, .turn_degrees = 30.0}, material);
    scene.lights.push_back(point_light({1, 1, 1}, Vec3(0.0f)));
    scene.camera = Camera{.eye = {0.3f, 0.8f, 1.9f}, .target = {0, 0, 0}, .fov_y_degrees = 60.0f};
    return scene;
}

Material glowing(float albedo, float emission) {
    Material material = matte(Vec3(albedo));
    material.emission = Vec3(emission);
    return material;
}

void expect_all(const Frame& frame, float wanted, float tolerance) {
    for (const Vec4& colour : frame.colour.pixels)
        for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(colour[channel], wanted, tolerance);
}

TEST(SampledLight, AClosedWhiteRoomIsWhite) {
    // Half is emitted, half scattered; the light that is everywhere stands for what came by more than one bounce.
    Scene scene = furnace(glowing(0.5f, 0.5f));
    scene.ambient = Vec3(1.0f);
    // Sums of a few numbers of which each is exact, so that no tolerance is needed.
    expect_all(picture_of(flatten(scene), {}, 8, 24), 1.0f, 0.0f);
}

TEST(SampledLight, OneBounceIsWhatItAdds) {
    constexpr float albedo = 0.75f, emission = 0.25f;
    expect_all(picture_of(flatten(furnace(glowing(albedo, emission))), {}, 8, 24), emission + albedo * emission, 0.0f);
}

TEST(SampledLight, WithoutSamplesRadiusAndRoughnessMeanNothing) {
    Scene scene = *make_procedural("cornell");
    const FlatScene soft = flatten(scene);
    for (Light& light : scene.lights) light.radius = 0.0f;
    for (Material& material : scene.materials) material.roughness = 0.0f;
    const FlatScene hard = flatten(scene);
    const KdTree tree = build_tree(soft.triangles, {});
    EXPECT_TRUE(same_frame(sample_of(soft, tree, {}, -1, 40), sample_of(hard, tree, {}, -1, 40)));
    EXPECT_FALSE(same_frame(sample_of(soft, tree, {}, 0, 40), sample_of(hard, tree, {}, 0, 40)));
}

/// A floor, seen from above, that a square keeps the left half of the light from.
FlatScene half_covered(float radius) {
    Scene scene;
    scene.ambient = Vec3(0.0f);
    place(scene,
          {.name = "floor",
           .positions = {{-50, 0, -50}, {-50, 0, 50}, {50, 0, 50}, {50, 0, -50}},
           .indices = {0, 1, 2, 0, 2, 3}},
          matte(Vec3(1.0f)));
    place(scene,
          {.name = "cover",
           .positions = {{-50, 2, -50}, {-50, 2, 50}, {0, 2, 50}, {0, 2, -50}},
           .indices = {0, 1, 2, 0, 2, 3}},
          matte(Vec3(0.0f)));
    scene.lights.push_back(point_light({0, 4, 0}, Vec3(1.0f), {1.0f, 0.0f}, radius));
    scene.camera = Camera{.eye = {0.001f, 1.9f, 0}, .target = {0.001f, 0, 0}, .up = {0, 0, 1}, .fov_y_degrees = 0.1f};
    return flatten(scene);
}

TEST(SampledLight, ALightHalfCoveredShinesHalf) {
    TraceConfig config;
    config.sampling.indirect = false;
    const Frame frame = picture_of(half_covered(0.5f), config, 256, 8);
    for (const Vec4& colour : frame.colour.pixels) EXPECT_NEAR(colour.x, 0.5f, 0.02f);  // worst measured: see below
    TraceConfig hard = config;
    hard.sampling.soft_shadows = false;
    const Frame sharp = picture_of(half_covered(0.5f), hard, 1, 8);
    for (const Vec4& colour : sharp.colour.pixels) EXPECT_TRUE(colour.x < 1e-6f || colour.x > 0.99f) << colour.x;
}

TEST(SampledLight, TheFloorIsTintedByTheWallsBesideIt) {
    TraceConfig config;
    const Frame frame = picture_of(flatten(*make_procedural("cornell")), config, 64, 32);
    const auto redness = [&](int x) {
        const Vec4 c = frame.colour.at(x, 29);
        return c.x / (c.y + c.z);
    };
    EXPECT_GT(redness(4), 1.1f * redness(27));
}

TEST(SampledLight, RoughnessBlursAMirror) {
    Material mirror = matte(Vec3(0.0f));
    mirror.reflectance = Vec3(1.0f);
    mirror.roughness = 0.5f;
    Scene scene = furnace(glowing(0.0f, 1.0f));
    scene.materials.back() = mirror;  // the cube's
    TraceConfig config;
    const Frame rough = picture_of(flatten(scene), config, 64, 16);
    config.sampling.gloss = false;
    const Frame smooth = picture_of(flatten(scene), config, 1, 16);
    expect_all(smooth, 1.0f, 1e-6f);
    // Facets behind facets keep some of the light: alpha 0.25 at no grazing angle, a few per cent.
    float darkest = 1.0f;
    for (const Vec4& colour : rough.colour.pixels) darkest = std::min(darkest, colour.x);
    EXPECT_LT(darkest, 0.999f);
    EXPECT_GT(darkest, 0.7f);
}

TEST(SampledLight, IsTheSameByEveryCpuTracer) {
    const FlatScene scene = test::soft_scene(200, 7);
    const KdTree tree = build_tree(scene.triangles, {});
    const TraceConfig config{.reflection_depth = 3, .sampling = {.seed = 5}};
    for (const int number : {0, 3}) {
        const Frame expected = sample_of(scene, tree, config, number, 37);
        for (int pass = 0; pass < pass_count; ++pass) {
            const auto& counters = expected.layer(Pass(pass)).counters.pixels;
            EXPECT_TRUE(std::ranges::any_of(counters, [](const RayCounters& c) { return c.rays > 0; })) << pass;
        }
        EXPECT_TRUE(same_frame(expected, sample_of(scene, tree, config, number, 37, CpuMode::wide)));
        EXPECT_TRUE(same_frame(expected, sample_of(scene, tree, config, number, 37, CpuMode::packet)));
    }
}

}  // namespace
}  // namespace kd
