// What surfaces send by themselves.

#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/parts.h"

namespace kd {
namespace {

/// A square wall before the camera, with coordinates 0..1, that no light reaches; behind the camera another one, which
/// a mirror in place of the wall shows.
Scene dark_room(const Material& wall) {
    Mesh square{.name = "wall",
                .positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}},
                .texture_coordinates = {{0, 1}, {1, 1}, {1, 0}, {0, 0}},
                .indices = {0, 1, 2, 0, 2, 3}};
    Scene scene;
    scene.ambient = Vec3(0.25f);
    place(scene, square, wall);
    scene.lights.push_back(point_light(Vec3(0, 0, 1), Vec3(0.0f)));
    scene.camera = Camera{.eye = {0, 0, 3}, .target = {0, 0, 0}, .fov_y_degrees = 40.0f};
    return scene;
}

Vec4 middle_of(const Scene& scene, const TraceConfig& config = {}) {
    const FlatScene flat = flatten(scene);
    const KdTree tree = build_tree(flat.triangles, {});
    Frame frame(9, 9);
    CpuTracer(flat, tree).trace_frame(config, pinhole(flat.camera, 9, 9), frame, 1);
    return frame.colour.at(4, 4);
}

TEST(Emission, IsAddedToWhatIsScattered) {
    Material lamp = matte(Vec3(0.5f));
    lamp.emission = Vec3(0.5f, 2.0f, 0.0f);
    EXPECT_EQ(middle_of(dark_room(lamp)), Vec4(0.625f, 2.125f, 0.125f, 1.0f));
}

TEST(Emission, IsTintedByItsOwnImage) {
    Material lamp = matte(Vec3(0.5f));
    lamp.emission = Vec3(0.5f);
    lamp.emission_texture = 1;
    Scene scene = dark_room(lamp);
    scene.textures = {plain_texture(Image<Rgba8>(1, 1, {0, 0, 0, 255})),
                      plain_texture(Image<Rgba8>(1, 1, {255, 0, 51, 255}))};
    const Vec4 found = middle_of(scene);
    EXPECT_FLOAT_EQ(found.x, 0.625f);
    EXPECT_FLOAT_EQ(found.y, 0.125f);
    EXPECT_FLOAT_EQ(found.z, 0.225f);
}

TEST(Emission, IsSeenInMirrors) {
    Material mirror = matte(Vec3(0.0f));
    mirror.reflectance = Vec3(0.5f);
    Scene scene = dark_room(mirror);
    scene.ambient = Vec3(0.0f);
    Material lamp = matte(Vec3(0.0f));
    lamp.emission = Vec3(0.25f, 0.5f, 4.0f);
    Mesh behind = scene.meshes.front();
    for (Vec3& p : behind.positions) p.z = 4.0f;
    place(scene, behind, lamp);
    EXPECT_EQ(middle_of(scene, {.reflection_depth = 1}), Vec4(0.125f, 0.25f, 2.0f, 1.0f));
    EXPECT_EQ(middle_of(scene, {.reflection_depth = 0}), Vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace kd
