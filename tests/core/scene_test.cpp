// From a scene as described to flat triangles: transforms, what is dropped, what is replaced.

#include "renderer/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/random.h"
#include "renderer/scene/units.h"
#include "tests/support/refusal.h"

namespace kd {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// One triangle in the plane z = 0, seen from +z, with the normals given.
Scene one_triangle(std::vector<Vec3> normals = {}) {
    Scene scene;
    Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .normals = std::move(normals), .indices = {0, 1, 2}};
    mesh.name = "one";
    place(scene, std::move(mesh), matte(Vec3(0.5f)));
    return scene;
}

Scene of_positions(std::vector<Vec3> positions, std::vector<std::uint32_t> indices) {
    Scene scene;
    place(scene, Mesh{.positions = std::move(positions), .indices = std::move(indices)}, matte(Vec3(0.5f)));
    return scene;
}

Scene box_under(const glm::mat4& to_world) {
    Scene scene;
    Mesh mesh;
    add_box(mesh, {.lower = Vec3(-1.0f), .upper = Vec3(1.0f)});
    place(scene, std::move(mesh), matte(Vec3(0.5f)));
    scene.instances[0].to_world = to_world;
    return scene;
}

glm::dvec3 area_vector(const Triangle& t) {
    return glm::cross(glm::dvec3(t.corner[1]) - glm::dvec3(t.corner[0]),
                      glm::dvec3(t.corner[2]) - glm::dvec3(t.corner[0]));
}

bool has_note(const FlatScene& flat, const std::string& note) {
    return std::ranges::find(flat.notes, note) != flat.notes.end();
}

std::string refusal(const Scene& scene) {
    return test::refusal([&] { (void)flatten(scene); });
}

TEST(Flatten, EmptySceneHasNoTrianglesButCanBeTraced) {
    const FlatScene flat = flatten(Scene{});
    EXPECT_TRUE(flat.triangles.empty());
    EXPECT_TRUE(flat.attributes.empty());
    EXPECT_TRUE(flat.bounds.empty());
    EXPECT_EQ(flat.camera, Camera{});
    EXPECT_EQ(flat.materials.size(), 1u);
    EXPECT_EQ(flat.lights.size(), 1u);
    EXPECT_FALSE(flat.has_normals);
}

TEST(Flatten, TransformsEveryInstance) {
    Scene scene = one_triangle();
    scene.instances.push_back({.mesh = 0, .to_world = glm::translate(glm::mat4(1.0f), Vec3(10, 20, 30))});
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.triangles.size(), 2u);
    EXPECT_EQ(flat.triangles[0], (Triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}));
    EXPECT_EQ(flat.triangles[1], (Triangle{{Vec3(10, 20, 30), Vec3(11, 20, 30), Vec3(10, 21, 30)}}));
    EXPECT_EQ(flat.bounds, (Aabb{{0, 0, 0}, {11, 21, 30}}));
    EXPECT_EQ(flat.attributes[1].normal[2], Vec3(0, 0, 1));
}

TEST(Flatten, TransformsInDouble) {
    // The product cancels against the translation: rounded to float in between, the difference is lost.
    glm::mat4 to_world(1.0f);
    to_world[0][0] = 16777215.0f;
    to_world[3][0] = -16777215.0f;
    const FlatScene flat = flatten([&] {
        Scene scene = of_positions({{1.0000001f, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {0, 1, 2});
        scene.instances[0].to_world = to_world;
        return scene;
    }());
    ASSERT_EQ(flat.triangles.size(), 1u);
    const double exact = 16777215.0 * double(1.0000001f) - 16777215.0;
    EXPECT_EQ(to_scene_units(flat, flat.triangles[0].corner[0]).x, float(exact));
    EXPECT_NE(float(exact), 16777215.0f * 1.0000001f - 16777215.0f) << "float would do: the test shows nothing";
}

TEST(Flatten, MirrorImagesKeepTheirOutside) {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        glm::mat4 to_world(1.0f);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) to_world[column][row] = float(random.between(-2, 2));
        }
        const FlatScene flat = flatten(box_under(to_world));
        ASSERT_EQ(flat.triangles.size(), 12u);
        for (std::size_t t = 0; t < 12; ++t) {
            const glm::dvec3 from_centre = glm::dvec3(flat.triangles[t].corner[0]) - glm::dvec3(Vec3(to_world[3]));
            EXPECT_GT(glm::dot(area_vector(flat.triangles[t]), from_centre), 0.0);
            EXPECT_GT(glm::dot(glm::dvec3(flat.attributes[t].normal[0]), from_centre), 0.0);
        }
    }
}

TEST(Flatten, MirrorImagesSwapAttributesWithCorners) {
    Scene scene = one_triangle({{0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}, {0, 0, 1}});
    scene.meshes[0].texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
    scene.instances[0].to_world = glm::scale(glm::mat4(1.0f), Vec3(-1, 1, 1));
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.triangles.size(), 1u);
    EXPECT_EQ(flat.triangles[0], (Triangle{{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)}}));
    const TriangleAttributes& a = flat.attributes[0];
    EXPECT_LT(glm::distance(a.normal[0], Vec3(-0.6f, 0, 0.8f)), 1e-6f);
    EXPECT_LT(glm::distance(a.normal[1], Vec3(0, 0, 1)), 1e-6f);
    EXPECT_LT(glm::distance(a.normal[2], Vec3(0, 0.6f, 0.8f)), 1e-6f);
    EXPECT_EQ(a.uv[1], Vec2(0, 1));
    EXPECT_EQ(a.uv[2], Vec2(1, 0));
}

TEST(Flatten, NormalsGoByTheInverseTranspose) {
    // A plane x + z = 1 squeezed to a quarter along x becomes 4x + z = 1.
    Scene scene = of_positions({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}, {0, 1, 2});
    scene.meshes[0].normals.assign(3, Vec3(0.70710678f, 0, 0.70710678f));
    scene.instances[0].to_world = glm::scale(glm::mat4(1.0f), Vec3(0.25f, 1, 1));
    const FlatScene flat = flatten(scene);
    for (const Vec3& normal : flat.attributes.at(0).normal)
        EXPECT_LT(glm::distance(normal, glm::normalize(Vec3(4, 0, 1))), 1e-6f);
    EXPECT_FALSE(flat.has_normals) << "the normals are the plane's own";
}

TEST(Flatten, DropsDegenerateTrianglesAndSaysHowMany) {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}};
    const FlatScene flat = flatten(of_positions(positions, {0, 1, 2,     // sound
                                                            0, 1, 1,     // an index twice
                                                            0, 4, 2,     // a point twice
                                                            0, 1, 3}));  // on one line
    EXPECT_EQ(flat.triangles.size(), 1u);
    EXPECT_EQ(flat.attributes.size(), 1u);
    EXPECT_TRUE(has_note(flat, "dropped 3 degenerate triangles")) << ::testing::PrintToString(flat.notes);
    EXPECT_TRUE(has_note(flatten(of_positions(positions, {0, 0, 0})), "dropped 1 degenerate triangle"));
}

TEST(Flatten, DropsCollinearTrianglesThatRotationWouldHide) {
    Scene scene = of_positions({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {0, 1, 2});
    scene.instances[0].to_world = glm::rotate(glm::mat4(1.0f), 0.7f, Vec3(1, 2, 3));
    EXPECT_TRUE(flatten(scene).triangles.empty());
}

TEST(Flatten, KeepsThinSlivers) {
    EXPECT_EQ(flatten(of_positions({{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-30f, 0}}, {0, 1, 2})).triangles.size(), 1u);
}

TEST(Flatten, SingularMatrices) {
    const auto scaled = [](Vec3 scale) {
        return flatten(
            box_under(glm::rotate(glm::mat4(1.0f), 0.4f, Vec3(1, 1, 0)) * glm::scale(glm::mat4(1.0f), scale)));
    };
    // Onto a plane: top and bottom stay, the four sides vanish.
    const FlatScene plane = scaled({1, 1, 0});
    EXPECT_EQ(plane.triangles.size(), 4u);
    EXPECT_TRUE(has_note(plane, "dropped 8 degenerate triangles")) << ::testing::PrintToString(plane.notes);
    for (const TriangleAttributes& a : plane.attributes) EXPECT_NEAR(glm::length(a.normal[0]), 1.0f, 1e-6f);
    // Onto a line and onto a point: nothing stays.
    EXPECT_TRUE(scaled({1, 0, 0}).triangles.empty());
    EXPECT_TRUE(scaled({0, 0, 0}).triangles.empty());
}

TEST(Flatten, DropsWhatIsNotFiniteOrTooFarOut) {
    for (const float bad : {nan, infinity, -infinity, 1.9e18f, -1.9e18f}) {
        const FlatScene flat =
            flatten(of_positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, bad, 1}}, {0, 1, 2, 0, 1, 3}));
        EXPECT_EQ(flat.triangles.size(), 1u) << bad;
        EXPECT_TRUE(has_note(flat, "dropped 1 triangle with coordinates that are not finite or beyond 1.844e18"))
            << ::testing::PrintToString(flat.notes);
        EXPECT_EQ(flat.bounds, (Aabb{{0, 0, 0}, {1, 1, 0}}));
    }
    const float limit = KD_COORDINATE_LIMIT;
    EXPECT_EQ(flatten(of_positions({{-limit, 0, 0}, {limit, 0, 0}, {0, limit, 0}}, {0, 1, 2})).triangles.size(), 1u);
}

TEST(Flatten, TransformThatIsNotFiniteDropsItsTriangles) {
    EXPECT_TRUE(flatten(box_under(glm::scale(glm::mat4(1.0f), Vec3(1, nan, 1)))).triangles.empty());
    EXPECT_TRUE(flatten(box_under(glm::translate(glm::mat4(1.0f), Vec3(infinity, 0, 0)))).triangles.empty());
}

TEST(Flatten, ReplacesBadNormalsAndSaysHowMany) {
    const FlatScene flat = flatten(one_triangle({{0, 0, 0}, {0, nan, 1}, {0, infinity, 0}}));
    for (const Vec3& normal : flat.attributes.at(0).normal) EXPECT_EQ(normal, Vec3(0, 0, 1));
    EXPECT_TRUE(has_note(flat, "replaced 3 vertex normals that cannot be used by the triangle's own"))
        << ::testing::PrintToString(flat.notes);
    EXPECT_FALSE(flat.has_normals);
}

TEST(Flatten, NormalsCountFromATenThousandthOfARadian) {
    const auto tilted = [](float angle) {
        return one_triangle({{0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, {0, 0, 1}});
    };
    EXPECT_FALSE(flatten(tilted(0.0f)).has_normals);
    EXPECT_FALSE(flatten(tilted(0.5e-4f)).has_normals);
    EXPECT_TRUE(flatten(tilted(2e-4f)).has_normals);
    EXPECT_TRUE(flatten(one_triangle({{0, 0, -1}, {0, 0, 1}, {0, 0, 1}})).has_normals) << "one points the other way";
}

TEST(Flatten, NormalsNeedNotBeUnit) {
    const FlatScene flat = flatten(one_triangle({{0, 0, 9}, {0, 3e-20f, 4e-20f}, {3e20f, 0, 4e20f}}));
    EXPECT_EQ(flat.attributes.at(0).normal[0], Vec3(0, 0, 1));
    EXPECT_LT(glm::distance(flat.attributes[0].normal[1], Vec3(0, 0.6f, 0.8f)), 1e-6f);
    EXPECT_LT(glm::distance(flat.attributes[0].normal[2], Vec3(0.6f, 0, 0.8f)), 1e-6f);
}

TEST(Flatten, ReplacesTextureCoordinatesThatAreNotFinite) {
    Scene scene = one_triangle();
    scene.meshes[0].texture_coordinates = {{0.5f, 0.5f}, {nan, 0}, {1, infinity}};
    const FlatScene flat = flatten(scene);
    EXPECT_EQ(flat.attributes.at(0).uv[0], Vec2(0.5f, 0.5f));
    EXPECT_EQ(flat.attributes[0].uv[1], Vec2(0, 0));
    EXPECT_EQ(flat.attributes[0].uv[2], Vec2(0, 0));
    EXPECT_TRUE(has_note(flat, "replaced 2 texture coordinates that are not finite by 0"));
}

TEST(Flatten, FitsACameraWhereThereIsNoneOrABadOne) {
    Scene scene = one_triangle();
    const FlatScene without = flatten(scene);
    EXPECT_EQ(without.camera, fit_camera(without.bounds));
    scene.camera = Camera{.eye = {0, nan, 0}};
    const FlatScene bad = flatten(scene);
    EXPECT_EQ(bad.camera, without.camera);
    EXPECT_TRUE(has_note(bad, "replaced the scene's camera, which cannot be used, by one that sees the whole scene"));
    scene.camera = Camera{.eye = {1, 2, 3}};
    EXPECT_EQ(flatten(scene).camera, *scene.camera);
}

TEST(Flatten, AddsALightUpRightOfTheCamera) {
    Scene scene = one_triangle();
    scene.camera = Camera{.eye = {0, 0, 10}, .target = {0, 0, 0}};
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.lights.size(), 1u);
    EXPECT_EQ(flat.lights[0].kind, KD_LIGHT_POINT);
    EXPECT_LT(glm::distance(flat.lights[0].position, Vec3(2, 3, 10)), 1e-5f);
    EXPECT_TRUE(has_note(flat, "added a point light beside the camera, as the scene has none"));
}

TEST(Flatten, KeepsTheScenesLightsButNoBrokenOnes) {
    Scene scene = one_triangle();
    scene.lights = {point_light({1, 2, 3}, Vec3(1.0f)), point_light({1, nan, 3}, Vec3(1.0f))};
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.lights.size(), 1u);
    EXPECT_EQ(flat.lights[0].position, Vec3(1, 2, 3));
    EXPECT_TRUE(has_note(flat, "dropped 1 light with values that are not finite"));
}

TEST(Flatten, KeepsNameNotesColoursAndTextures) {
    Scene scene = one_triangle();
    scene.name = "a name";
    scene.notes = {"said before"};
    scene.ambient = Vec3(0.3f);
    scene.background = Vec3(0.4f);
    scene.textures = {plain_texture(Image<Rgba8>(2, 2, {1, 2, 3, 4})), plain_texture(Image<Rgba8>(3, 1, {5, 6, 7, 8}))};
    scene.textures[1].wrap_y = KD_WRAP_MIRROR;
    scene.lights = {point_light({1, 2, 3}, Vec3(1.0f))};
    const FlatScene flat = flatten(scene);
    EXPECT_EQ(flat.name, "a name");
    EXPECT_EQ(flat.notes, std::vector<std::string>{"said before"});
    EXPECT_EQ(flat.ambient, Vec3(0.3f));
    EXPECT_EQ(flat.background, Vec3(0.4f));
    ASSERT_EQ(flat.textures.size(), 2u);
    EXPECT_EQ(flat.textures[1].first, 4);
    EXPECT_EQ(flat.textures[1].width, 3);
    EXPECT_EQ(flat.textures[1].levels, 1);
    EXPECT_EQ(flat.textures[1].wrap_y, KD_WRAP_MIRROR);
    EXPECT_EQ(flat.texels.at(3), (Rgba8{1, 2, 3, 4}));
    EXPECT_EQ(flat.texels.at(6), (Rgba8{5, 6, 7, 8}));
}

TEST(Flatten, SurfacesWithoutMaterialAreGrey) {
    Scene scene = one_triangle();
    scene.materials.clear();
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.materials.size(), 1u);
    EXPECT_EQ(flat.materials[0].diffuse, Vec3(0.7f));
    EXPECT_EQ(flat.materials[0].texture, -1);
    EXPECT_EQ(flat.attributes.at(0).material, 0);
}

TEST(Flatten, RefusesNumbersThatPointNowhere) {
    Scene scene = one_triangle();
    scene.meshes[0].indices = {0, 1, 3};
    EXPECT_EQ(refusal(scene), "mesh 0 'one': index 3 is outside its 3 positions; correct the index");
    scene.meshes[0].indices = {0, 1};
    EXPECT_EQ(refusal(scene), "mesh 0 'one': 2 indices are no whole number of triangles; give three per triangle");
    scene = one_triangle({{0, 0, 1}});
    EXPECT_EQ(refusal(scene), "mesh 0 'one': 1 normals for 3 positions; give one each or none");
    scene = one_triangle();
    scene.meshes[0].material = 1;
    EXPECT_EQ(refusal(scene), "mesh 0 'one': material 1 is not one of the scene's 1; correct it");
    scene = one_triangle();
    scene.instances[0].mesh = -1;
    EXPECT_EQ(refusal(scene), "instance 0: mesh -1 is not one of the scene's 1; correct it");
    scene = one_triangle();
    scene.materials[0].texture = 0;
    EXPECT_EQ(refusal(scene), "material 0: texture 0 is not one of the scene's 0; correct it, or use -1 for none");
    scene.textures.resize(1);
    EXPECT_EQ(refusal(scene), "texture 0: there is no image; give one");
    scene.textures[0].levels.resize(1);
    EXPECT_EQ(refusal(scene), "texture 0: the image has no pixels; give at least one");
    scene.textures[0].levels = {Image<Rgba8>(4, 5), Image<Rgba8>(2, 3)};
    EXPECT_EQ(refusal(scene), "texture 0: level 1 is not half of the one before it; halve it");
    EXPECT_EQ(refusal(one_triangle()), "accepted");
}

}  // namespace
}  // namespace kd
