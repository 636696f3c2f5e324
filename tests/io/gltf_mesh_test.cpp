#include <glm/gtc/matrix_transform.hpp>

#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

using Indices = std::vector<std::uint32_t>;

const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
const std::vector<Vec3> fan{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}};

GltfBuilder primitive_of(const std::vector<Vec3>& positions, int mode) {
    GltfBuilder builder;
    builder.add_primitive({{"POSITION", builder.add_vec3(positions)}})["mode"] = mode;
    return builder;
}

TEST(GltfMesh, ReadsTrianglesWithoutIndices) {
    const Scene scene = load(one_triangle());
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2}));
    EXPECT_TRUE(scene.meshes[0].normals.empty());
    EXPECT_EQ(scene.name, "scene.gltf");
    EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
    EXPECT_FALSE(scene.camera.has_value());
    EXPECT_TRUE(scene.lights.empty());
}

TEST(G19, StripsKeepTheirWinding) {
    const Scene scene = load(primitive_of(square, 5));
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{0, 1, 2, 1, 3, 2}));
    // Seen from +z, both must be counter-clockwise.
    const Mesh& mesh = scene.meshes[0];
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = mesh.positions[mesh.indices[i]];
        const Vec3 b = mesh.positions[mesh.indices[i + 1]] - a;
        const Vec3 c = mesh.positions[mesh.indices[i + 2]] - a;
        EXPECT_GT(b.x * c.y - b.y * c.x, 0.0f);
    }
}

TEST(G19, FansShareTheirFirstVertex) {
    EXPECT_EQ(load(primitive_of(fan, 6)).meshes.at(0).indices, (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(GltfMesh, IndexedStripsAndFansFollowTheirIndices) {
    for (const int mode : {5, 6}) {
        GltfBuilder builder = primitive_of(square, mode);
        builder.json["meshes"][0]["primitives"][0]["indices"] = builder.add_indices({3, 2, 1, 0});
        const Indices expected = mode == 5 ? Indices{3, 2, 1, 2, 0, 1} : Indices{2, 1, 3, 1, 0, 3};
        EXPECT_EQ(load(builder).meshes.at(0).indices, expected) << "mode " << mode;
    }
}

TEST(GltfMesh, TooFewVerticesMakeNoTriangle) {
    for (const int mode : {4, 5, 6}) {
        const Scene scene = load(primitive_of({{0, 0, 0}, {1, 0, 0}}, mode));
        EXPECT_TRUE(scene.meshes.at(0).indices.empty()) << "mode " << mode;
    }
}

TEST(G19, SkipsAndCountsPointsAndLines) {
    GltfBuilder builder = one_triangle();
    for (const int mode : {0, 1, 2, 3}) builder.add_primitive({{"POSITION", 0}})["mode"] = mode;
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_TRUE(has_note(scene, "skipped 4 primitives of points or lines"));
}

TEST(G12, CountsWhatMakesNoWholeTriangleAndIndicesThatNameNothing) {
    GltfBuilder builder = primitive_of(square, 4);
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.add_indices({0, 1, 2, 0, 1, 4, 65535, 1, 2, 1, 3});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{0, 1, 2}));
    EXPECT_TRUE(has_note(scene, "dropped 2 triangles with an index that names no vertex"));
    EXPECT_TRUE(has_note(scene, "ignored the last vertices of 1 primitive"));
}

TEST(GltfMesh, ReadsIndicesOfEveryWidth) {
    GltfBuilder builder;
    const std::size_t positions = builder.add_vec3(square);
    const Indices expected{0, 1, 3, 0, 3, 2};
    const std::vector<std::uint8_t> narrow(expected.begin(), expected.end());
    const std::vector<std::uint16_t> middle(expected.begin(), expected.end());
    const std::size_t accessors[] = {builder.add_accessor(narrow, "SCALAR", 5121, 6), builder.add_indices(middle),
                                     builder.add_accessor(expected, "SCALAR", 5125, 6)};
    for (const std::size_t a : accessors) builder.add_primitive({{"POSITION", positions}})["indices"] = a;
    const Scene scene = load(builder);
    ASSERT_EQ(scene.meshes.size(), 3u);
    for (const Mesh& mesh : scene.meshes) EXPECT_EQ(mesh.indices, expected);
}

TEST(GltfMesh, ReadsInterleavedVertices) {
    struct Vertex {
        Vec3 position, normal;
    };
    const std::vector<Vertex> vertices{{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}}};
    GltfBuilder builder;
    builder.add_view(vertices.data(), vertices.size() * sizeof(Vertex));
    builder.json["bufferViews"][0]["byteStride"] = sizeof(Vertex);
    for (const std::size_t offset : {std::size_t(0), sizeof(Vec3)}) {
        builder.json["accessors"].push_back(
            {{"bufferView", 0}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    }
    builder.add_primitive({{"POSITION", 0}, {"NORMAL", 1}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.at(0).positions[2], Vec3(0, 1, 0));
    EXPECT_EQ(scene.meshes.at(0).normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST(G15, SparseValuesReplaceThoseBelow) {
    GltfBuilder builder = one_triangle();
    const std::vector<std::uint8_t> indices{0, 2};
    const std::vector<Vec3> values{{5, 5, 5}, {6, 6, 6}};
    builder.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", builder.add_view(indices.data(), 2)}, {"componentType", 5121}}},
        {"values", {{"bufferView", builder.add_view(values.data(), 24)}}}};
    EXPECT_EQ(load(builder).meshes.at(0).positions, (std::vector<Vec3>{{5, 5, 5}, {1, 0, 0}, {6, 6, 6}}));

    builder.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(load(builder).meshes.at(0).positions, (std::vector<Vec3>{{5, 5, 5}, {0, 0, 0}, {6, 6, 6}}));

    builder.bytes[builder.json["bufferViews"][2]["byteOffset"].get<std::size_t>() + 1] = 3;
    EXPECT_EQ(load_error(builder.text()),
              "scene.gltf: /accessors/0/sparse/indices: index 3 is outside of the accessor's 3 elements");
}

TEST(GltfMesh, NormalisedIntegersBecomeFractions) {
    GltfBuilder builder = one_triangle();
    builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"uri", "none.png"}}};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    const auto with = [&](std::size_t accessor) {
        builder.json["accessors"][accessor]["normalized"] = true;
        builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = accessor;
        return load(builder).meshes.at(0).texture_coordinates;
    };
    const std::vector<std::uint8_t> bytes{0, 255, 51, 0, 255, 0};
    EXPECT_EQ(with(builder.add_accessor(bytes, "VEC2", 5121, 3)), (std::vector<Vec2>{{0, 1}, {0.2f, 0}, {1, 0}}));
    const std::vector<std::uint16_t> shorts{0, 65535, 13107, 0, 65535, 0};
    EXPECT_EQ(with(builder.add_accessor(shorts, "VEC2", 5123, 3)), (std::vector<Vec2>{{0, 1}, {0.2f, 0}, {1, 0}}));
    const std::vector<std::int8_t> signed_bytes{-128, 127, -127, 0, 127, 0};
    EXPECT_EQ(with(builder.add_accessor(signed_bytes, "VEC2", 5120, 3)), (std::vector<Vec2>{{-1, 1}, {-1, 0}, {1, 0}}));
}

GltfBuilder quantized_triangle() {
    GltfBuilder builder;
    const std::vector<std::int16_t> shorts{0, 0, 0, 0, -300, 0, 7, 0, 0, 40, 1, 0};  // padded to 8 bytes
    builder.add_accessor(shorts, "VEC3", 5122, 3);
    builder.json["bufferViews"][0]["byteStride"] = 8;
    builder.add_primitive({{"POSITION", 0}});
    return builder;
}

TEST(G11, QuantizedPositionsAreReadAsTheyAre) {
    for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
        GltfBuilder builder = quantized_triangle();
        builder.json[list] = {"KHR_mesh_quantization"};
        const Scene scene = load(builder);
        EXPECT_EQ(scene.meshes.at(0).positions, (std::vector<Vec3>{{0, 0, 0}, {-300, 0, 7}, {0, 40, 1}}));
        EXPECT_TRUE(scene.notes.empty()) << list << ": " << scene.notes[0];
    }
}

TEST(G11, QuantizedPositionsWithoutTheirExtensionAreReadAndTold) {
    const Scene scene = load(quantized_triangle());
    EXPECT_EQ(scene.meshes.at(0).positions, (std::vector<Vec3>{{0, 0, 0}, {-300, 0, 7}, {0, 40, 1}}));
    EXPECT_TRUE(has_note(scene, "read the positions of 1 primitive, which are integers though KHR_mesh_quantization is "
                                "missing"));
}

TEST(G11, AttributesThatDoNotFitAreIgnored) {
    GltfBuilder builder = one_triangle();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_vec3({{0, 0, 1}});
    attributes["COLOR_0"] = attributes["NORMAL"];
    const Scene scene = load(builder);
    EXPECT_TRUE(scene.meshes.at(0).normals.empty());
    EXPECT_TRUE(has_note(scene, "ignored the normals of 1 primitive, which do not fit its positions"));
    EXPECT_TRUE(has_note(scene, "ignored the vertex colours of 1 primitive"));
}

TEST(G11, PrimitivesWithoutPositionsAreSkipped) {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"TEXCOORD_0", 1}}}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(has_note(scene, "skipped 1 primitive without positions"));
}

TEST(G10, HugeCountsAreRefusedBeforeAnythingIsExpanded) {
    // An accessor without a bufferView holds zeros, as many as it says.
    GltfBuilder builder = one_triangle();
    builder.json["accessors"][0].erase("bufferView");
    builder.json["accessors"][0]["count"] = 1'000'000'000'000ull;
    EXPECT_TRUE(holds(load_error(builder.text()), "triangles with all instances; the limit is 50000000"));
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.add_indices({0, 1, 2});
    EXPECT_TRUE(holds(load_error(builder.text()), "at least 50000001 vertices; the limit is 50000000"));
}

TEST(G28, InstancesCountTowardsTheLimit) {
    GltfBuilder builder;
    builder.add_primitive({{"POSITION", builder.add_vec3(std::vector<Vec3>(30'000, Vec3(0)))}});
    for (int i = 0; i < 5'000; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    EXPECT_TRUE(holds(load_error(builder.text()), "50010000 triangles with all instances"));
}

TEST(GltfNode, TransformsMultiplyFromTheRootDown) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                             {{"scale", {2, 3, -4}}, {"rotation", {0, 0, 2, 2}}, {"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {0}}}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 1u);
    const glm::mat4 m = scene.instances[0].to_world;
    // Scale, then a quarter turn about z (the quaternion is not of unit length), then the parent's move.
    const glm::vec4 p = m * glm::vec4(1, 1, 1, 1);
    EXPECT_NEAR(p.x, 10 - 3, 1e-5);
    EXPECT_NEAR(p.y, 2, 1e-5);
    EXPECT_NEAR(p.z, -4, 1e-5);
    EXPECT_NEAR(glm::determinant(m), -24, 1e-4) << "a mirror image stays one";

    // flatten() turns a mirrored triangle, so that its outside stays outside.
    const FlatScene flat = flatten(scene);
    ASSERT_EQ(flat.triangles.size(), 1u);
    EXPECT_NEAR(flat.attributes[0].normal[0].z, -1, 1e-5);
}

TEST(GltfNode, MatricesAreStoredByColumns) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 11, 12, 13, 1};
    const glm::mat4 m = load(builder).instances.at(0).to_world;
    EXPECT_EQ(m[0], glm::vec4(1, 2, 3, 0));
    EXPECT_EQ(m[3], glm::vec4(11, 12, 13, 1));
}

TEST(GltfNode, OneMeshShownTwiceIsStoredOnce) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 1}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(flatten(scene).triangles.size(), 2u);
}

TEST(GltfNode, OnlyTheDefaultSceneIsShown) {
    GltfBuilder builder = one_triangle();
    builder.add_primitive({{"POSITION", 0}});
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {0, 1}}}};
    EXPECT_EQ(load(builder).instances.size(), 1u);
    builder.json["scene"] = 1;
    EXPECT_EQ(load(builder).instances.size(), 2u);
    builder.json.erase("scene");
    builder.json.erase("scenes");
    EXPECT_EQ(load(builder).instances.size(), 2u) << "without scenes, all trees are shown";
}

TEST(G16, DeepChainsDoNotExhaustTheStack) {
    GltfBuilder builder = one_triangle();
    auto& nodes = builder.json["nodes"];
    const std::size_t depth = 100'000;
    for (std::size_t i = 0; i < depth; ++i) nodes.push_back({{"children", {i + 2}}, {"translation", {0, 0, 1}}});
    nodes.push_back({{"mesh", 0}});
    builder.json["scenes"] = {{{"nodes", {1}}}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].to_world[3].z, float(depth));
}

TEST(G18, AZeroRotationIsIgnored) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.instances.at(0).to_world, glm::mat4(1.0f));
    EXPECT_TRUE(has_note(scene, "ignored 1 rotation"));
}

TEST(G20, BrokenSkinsMorphTargetsAndAnimationsDoNoHarm) {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 1}}};
    builder.json["skins"] = {{{"joints", {0}}}};
    builder.json["animations"] = {{{"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}}};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.notes, (std::vector<std::string>{"ignored the positions of morph targets of 1 primitive, which do "
                                                     "not fit its positions"}));
    EXPECT_FALSE(scene.motion);
}

}  // namespace
}  // namespace kd
