// The glTF models, good and broken, that Debian ships as assimp-testmodels.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "renderer/io/gltf.h"
#include "renderer/scene/motion.h"
#include "renderer/scene/moving_scene.h"
#include "tests/io/scratch.h"

namespace kd {
namespace {

namespace fs = std::filesystem;

const fs::path models = "/usr/share/assimp/models/glTF2";

#define NEEDS_MODELS()                                                                                                 \
    if (!fs::exists(models)) GTEST_SKIP() << "the package assimp-testmodels is not installed"

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        count += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
    return count;
}

std::string error_of_model(const char* name) {
    return error_of([&] { (void)load_gltf(models / name); });
}

TEST(Models, EachLoadsOrIsRefusedInOneLine) {
    NEEDS_MODELS();
    int loaded = 0;
    int refused = 0;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        const std::string type = entry.path().extension().string();
        if (type != ".gltf" && type != ".glb") continue;
        SCOPED_TRACE(entry.path());
        const std::string error = error_of([&] {
            const FlatScene flat = flatten(load_gltf(entry.path()));
            EXPECT_TRUE(is_valid(flat.camera));
        });
        EXPECT_TRUE(error.empty() || error.starts_with(entry.path().string() + ": ")) << error;
        ++(error.empty() ? loaded : refused);
    }
    EXPECT_GE(loaded, 30);
    EXPECT_GE(refused, 8);
}

TEST(Models, TwoCylinderEngine) {
    NEEDS_MODELS();
    const Scene scene = load_gltf(models / "2CylinderEngine-glTF-Binary" / "2CylinderEngine.glb");
    EXPECT_EQ(triangle_count(scene), 121496u);
    EXPECT_EQ(scene.instances.size(), 115u);
    EXPECT_EQ(scene.meshes.size(), 34u);
    EXPECT_TRUE(scene.camera.has_value());
    EXPECT_TRUE(scene.notes.empty());
    for (const Mesh& mesh : scene.meshes) EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
}

TEST(Models, BoxTexturedIsTheSameInEveryPacking) {
    NEEDS_MODELS();
    const Scene text = load_gltf(models / "BoxTextured-glTF" / "BoxTextured.gltf");
    const Scene binary = load_gltf(models / "BoxTextured-glTF-Binary" / "BoxTextured.glb");
    const Scene embedded = load_gltf(models / "BoxTextured-glTF-Embedded" / "BoxTextured.gltf");
    EXPECT_EQ(triangle_count(text), 12u);
    ASSERT_EQ(text.textures.size(), 1u);
    EXPECT_EQ(text.textures[0].levels.at(0).width, 211);
    EXPECT_EQ(text.textures[0].levels.at(0).height, 211);
    EXPECT_EQ(text.textures[0].levels.size(), 8u) << "211 halved to 1";
    EXPECT_EQ(text.textures[0].wrap_x, KD_WRAP_MIRROR) << "of the three this file alone says so";
    EXPECT_EQ(text.textures[0].wrap_y, KD_WRAP_CLAMP);
    EXPECT_EQ(text.materials.at(0).texture, 0);
    EXPECT_EQ(text.meshes.at(0).texture_coordinates.size(), 24u);
    for (const Scene* other : {&binary, &embedded}) {
        EXPECT_EQ(other->textures.at(0).levels, text.textures[0].levels);
        EXPECT_EQ(other->meshes.at(0).positions, text.meshes[0].positions);
        EXPECT_EQ(other->meshes[0].texture_coordinates, text.meshes[0].texture_coordinates);
        EXPECT_EQ(other->meshes[0].indices, text.meshes[0].indices);
    }
}

TEST(Models, SimpleSkinBends) {
    NEEDS_MODELS();
    const Scene rest = load_gltf(models / "simple_skin" / "simple_skin.gltf");
    ASSERT_TRUE(rest.motion);
    EXPECT_EQ(rest.motion->duration(), 5.5);
    EXPECT_TRUE(rest.notes.empty());
    // Both joints stand at y = 1 and hold the mesh by (0.5, 1); after a second the upper one has turned a right angle.
    EXPECT_EQ(rest.meshes.at(0).positions.at(8), Vec3(-0.5f, 2, 0));
    Scene bent = rest;
    bent.motion->pose(bent, 1.0);
    EXPECT_EQ(bent.meshes.at(0).positions.at(0), Vec3(-0.5f, 0, 0));
    EXPECT_LT(glm::distance(bent.meshes[0].positions.at(8), Vec3(-1, 0.5f, 0)), 1e-3f) << "its keys have 3 digits";
}

TEST(Models, AnimatedMorphCubeGrowsAndShrinks) {
    NEEDS_MODELS();
    const MovingScene scene(
        load_gltf(models / "glTF-Sample-Models" / "AnimatedMorphCube-glTF" / "AnimatedMorphCube.gltf"));
    EXPECT_NEAR(scene.duration(), 4.2, 1e-3);
    std::set<double> areas;
    for (int i = 0; i < 8; ++i) areas.insert(scene.at(scene.duration() * i / 8).bounds.surface_area());
    EXPECT_GE(areas.size(), 4u);
}

TEST(Models, ClearCoatHasManyNodes) {
    NEEDS_MODELS();
    const Scene scene = load_gltf(models / "ClearCoat-glTF" / "ClearCoatTest.gltf");
    EXPECT_EQ(triangle_count(scene), 37116u);
    EXPECT_EQ(scene.instances.size(), 27u);
    EXPECT_EQ(scene.materials.size(), 19u);
    const bool told = std::ranges::find(scene.notes, "ignored extension KHR_materials_clearcoat") != scene.notes.end();
    EXPECT_TRUE(told);
}

TEST(Models, Cameras) {
    NEEDS_MODELS();
    const Scene scene = load_gltf(models / "cameras" / "Cameras.gltf");
    EXPECT_EQ(triangle_count(scene), 2u);
    ASSERT_TRUE(scene.camera.has_value());
    EXPECT_EQ(scene.camera->eye, Vec3(0.5f, 0.5f, 3.0f));
    EXPECT_NEAR(scene.camera->fov_y_degrees, 40.107, 1e-3);
    EXPECT_NEAR(scene.camera->target.x, 0.5f, 1e-6);
    EXPECT_LT(scene.camera->target.z, 3.0f);
}

TEST(Models, TriangleModesAgree) {
    NEEDS_MODELS();
    // The asset generator draws the same square by every mode: 4 to 6 without indices, 11 to 15 with them.
    for (const char* number : {"04", "05", "06", "11", "12", "13", "14", "15"}) {
        const fs::path file = std::string("Mesh_PrimitiveMode_") + number + ".gltf";
        const FlatScene flat = flatten(load_gltf(models / "glTF-Asset-Generator" / "Mesh_PrimitiveMode" / file));
        ASSERT_EQ(flat.triangles.size(), 2u) << number;
        for (const TriangleAttributes& a : flat.attributes) EXPECT_NEAR(a.normal[0].z, 1.0f, 1e-6) << number;
        EXPECT_NEAR(flat.bounds.surface_area(), 2.0, 1e-5) << number;
    }
}

TEST(Models, TextureTransformTurnsTheArrowToItsTarget) {
    NEEDS_MODELS();
    const Scene scene = load_gltf(models / "textureTransform" / "TextureTransformTest.gltf");
    // In the picture an arrow points from the corner along u = v. On the square "Rotation", it must point to where the
    // model puts its mark "Correct": (-0.079, -0.516) from the middle, and not to its mirror image.
    const auto rotation = std::ranges::find(scene.meshes, "Rotation", &Mesh::name);
    ASSERT_NE(rotation, scene.meshes.end());
    ASSERT_EQ(rotation->positions.size(), 4u);
    const Vec2 origin = rotation->texture_coordinates[0];
    const Vec2 along_x =
        rotation->texture_coordinates[1] - origin;  // position 0 is top left, 1 top right, 3 bottom left
    const Vec2 along_y = rotation->texture_coordinates[3] - origin;
    const Vec2 mark(0.5f - 0.07904822f, 0.5f + 0.5162675f);  // from the top left corner
    const Vec2 uv = origin + mark.x * along_x + mark.y * along_y;
    EXPECT_NEAR(uv.x, uv.y, 1e-3);
}

TEST(Models, BrokenOnesSayWhatIsWrong) {
    NEEDS_MODELS();
    EXPECT_TRUE(holds(error_of_model("MissingBin/BoxTextured.gltf"), "BoxTextured.gltf: /buffers/0/uri: cannot read "));
    EXPECT_TRUE(holds(error_of_model("MissingBin/BoxTextured.gltf"), "BoxTextured0.bin: it does not exist"));
    EXPECT_TRUE(holds(error_of_model("RecursiveNodes/RecursiveNodes.gltf"), "/nodes/0: reached twice"));
    EXPECT_TRUE(holds(error_of_model("draco/2CylinderEngine.gltf"),
                      "/extensionsRequired/0: extension KHR_draco_mesh_compression is not supported"));
    EXPECT_TRUE(
        holds(error_of_model("IncorrectVertexArrays/Cube.gltf"), "/bufferViews/2/byteLength: 432 bytes from 504"));
    EXPECT_TRUE(holds(error_of_model("wrongTypes/badArray.gltf"), "/meshes/0/primitives: must be a list"));
    EXPECT_TRUE(holds(error_of_model("SchemaFailures/sceneWrongType.gltf"), "/scene: "));
}

TEST(Models, IndicesOutOfRangeAreDroppedAndCounted) {
    NEEDS_MODELS();
    const Scene some = load_gltf(models / "IndexOutOfRange" / "IndexOutOfRange.gltf");
    EXPECT_EQ(triangle_count(some), 11u);
    EXPECT_EQ(some.notes.at(0), "dropped 1 triangle with an index that names no vertex");
    const Scene all = load_gltf(models / "IndexOutOfRange" / "AllIndicesOutOfRange.gltf");
    EXPECT_EQ(triangle_count(all), 0u);
    EXPECT_EQ(all.notes.at(0), "dropped 12 triangles with an index that names no vertex");
}

TEST(Models, BadNumbersAreLeftToFlatten) {
    NEEDS_MODELS();
    const FlatScene infinite = flatten(load_gltf(models / "BoxWithInfinites-glTF-Binary" / "BoxWithInfinites.glb"));
    EXPECT_LT(infinite.triangles.size(), 12u);
    EXPECT_TRUE(std::isfinite(infinite.bounds.surface_area()));
    const FlatScene normals = flatten(load_gltf(models / "BoxBadNormals-glTF-Binary" / "BoxBadNormals.glb"));
    EXPECT_EQ(normals.triangles.size(), 12u);
}

}  // namespace
}  // namespace kd
