// Bad files that load all the same, with what was dropped or replaced counted and told. Numbers as in
// docs/stability.md, "Bad input".
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/io/gltf_samples.h"

namespace kd {
namespace {

using nlohmann::json;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

bool has_note(const FlatScene& flat, const std::string& part) {
    return std::ranges::any_of(flat.notes, [&](const std::string& n) { return n.find(part) != std::string::npos; });
}

FlatScene flat_of(const GltfBuilder& builder) { return flatten(load(builder)); }

TEST(G13, WrongMinAndMaxAreReplacedByThoseOfThePositions) {
    GltfBuilder builder = one_triangle();
    builder.json["accessors"][0]["min"] = {0, 0, 0};
    builder.json["accessors"][0]["max"] = {1, 1, 0};
    EXPECT_TRUE(load(builder).notes.empty());
    for (const json& wrong : {json{5, 5, 5}, json{0, 0, -1e-3}, json{1e300, 0, 0}}) {
        builder.json["accessors"][0]["min"] = wrong;
        const FlatScene flat = flat_of(builder);
        EXPECT_EQ(flat.bounds.lower, Vec3(0));
        EXPECT_EQ(flat.bounds.upper, Vec3(1, 1, 0));
        EXPECT_TRUE(has_note(flat, "ignored min and max of 1 primitive, which are not those of its positions"))
            << wrong;
    }
    for (const json& odd :
         {json::array(), json{1, 2}, json{"a", "b", "c"}, json("x"), json{nullptr, nullptr, nullptr}}) {
        builder.json["accessors"][0]["min"] = odd;
        EXPECT_EQ(load_error(builder.text()), "") << odd;
    }
}

TEST(G14, PositionsThatAreNotFiniteOrTooLarge) {
    GltfBuilder builder;
    builder.add_primitive({{"POSITION", builder.add_vec3({{0, 0, 0},
                                                          {1, 0, 0},
                                                          {0, 1, 0},  //
                                                          {nan, 0, 0},
                                                          {1, 0, 0},
                                                          {0, 1, 0},  //
                                                          {0, 0, 0},
                                                          {infinity, 0, 0},
                                                          {0, 1, 0},  //
                                                          {0, 0, 0},
                                                          {1, 0, 0},
                                                          {0, -1.9e18f, 0},  //
                                                          {0, 0, 0},
                                                          {1e-42f, 0, 0},
                                                          {0, 1e-42f, 0},  //
                                                          {2, 2, 2},
                                                          {2, 2, 2},
                                                          {2, 2, 2}})}});
    const FlatScene flat = flat_of(builder);
    EXPECT_EQ(flat.triangles.size(), 1u);
    EXPECT_TRUE(has_note(flat, "dropped 3 triangles with coordinates that are not finite or beyond 1.844e18"));
    EXPECT_TRUE(has_note(flat, "dropped 1 degenerate triangle"));
    EXPECT_TRUE(has_note(flat, "dropped 1 triangle too small beside the scene"));
    EXPECT_EQ(flat.bounds.upper, Vec3(1, 1, 0));
}

TEST(G14, NormalsAndTextureCoordinatesThatAreNotFinite) {
    GltfBuilder builder = rich_file();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_vec3({{nan, 0, 1}, {0, 0, 0}, {0, 0, infinity}});
    attributes["TEXCOORD_0"] = builder.add_vec2({{nan, 0}, {0, infinity}, {0, 1}});
    const FlatScene flat = flat_of(builder);
    ASSERT_FALSE(flat.triangles.empty());
    for (const TriangleAttributes& a : flat.attributes)
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_NEAR(std::abs(a.normal[corner].z), 1.0f, 1e-6f);
            EXPECT_TRUE(std::isfinite(a.uv[corner].x) && std::isfinite(a.uv[corner].y));
        }
    EXPECT_TRUE(has_note(flat, "replaced 12 vertex normals that cannot be used by the triangle's own"));
    EXPECT_TRUE(has_note(flat, "replaced 8 texture coordinates that are not finite by 0"));
}

TEST(G15, SparseIndicesInAnyOrderAreApplied) {
    GltfBuilder builder = one_triangle();
    const std::vector<std::uint8_t> indices{2, 0, 2};
    const std::vector<Vec3> values{{5, 5, 5}, {6, 6, 6}, {7, 7, 7}};
    builder.json["accessors"][0]["sparse"] = {
        {"count", 3},
        {"indices", {{"bufferView", builder.add_view(indices.data(), 3)}, {"componentType", 5121}}},
        {"values", {{"bufferView", builder.add_view(values.data(), 36)}}}};
    EXPECT_EQ(load(builder).meshes.at(0).positions, (std::vector<Vec3>{{6, 6, 6}, {1, 0, 0}, {7, 7, 7}}));
}

TEST(G17, MatricesThatLeaveNoTriangle) {
    const json zero = json(std::vector<int>(16, 0));
    const json flat_in_x = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (const json& matrix : {zero, flat_in_x}) {
        GltfBuilder builder = one_triangle();
        builder.json["nodes"][0]["matrix"] = matrix;
        EXPECT_TRUE(has_note(flat_of(builder), "dropped 1 degenerate triangle")) << matrix;
    }
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["scale"] = {1e30, 1e30, 1e30};
    EXPECT_TRUE(
        has_note(flat_of(builder), "dropped 1 triangle with coordinates that are not finite or beyond 1.844e18"));
    builder.json["nodes"][0]["scale"] = {1e300, 1e300, 1e300};
    EXPECT_TRUE(
        has_note(flat_of(builder), "dropped 1 triangle with coordinates that are not finite or beyond 1.844e18"));
    builder.json["nodes"][0]["scale"] = {1, 0, 1};
    EXPECT_TRUE(has_note(flat_of(builder), "dropped 1 degenerate triangle"));
}

TEST(G17, ShearAndPerspectiveRowsDoNoHarm) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 7, 0.5, 1, 0, 8, 0, 0, 1, 9, 0, 0, 0, 0};
    const FlatScene flat = flat_of(builder);
    ASSERT_EQ(flat.triangles.size(), 1u);
    EXPECT_EQ(flat.bounds.upper, Vec3(1, 1, 0)) << "the fourth row is not used";
}

TEST(G18, RotationsBeyondMeasureAreIgnored) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["rotation"] = {1e300, 1e300, 0, 0};
    EXPECT_TRUE(has_note(flat_of(builder), "ignored 1 rotation of length zero or beyond measure"));
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 1e-3};
    EXPECT_EQ(load(builder).instances.at(0).to_world, glm::mat4(1.0f)) << "made a unit quaternion";
}

TEST(G21, TexturesThatNameNoImage) {
    GltfBuilder builder = rich_file();
    builder.json["textures"][0]["source"] = 7;
    EXPECT_TRUE(has_note(load(builder), "ignored 1 texture without an image that can be shown"));
    builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 9;
    EXPECT_TRUE(has_note(load(builder), "ignored 1 texture without an image that can be shown"));
}

TEST(G22, WhatAPictureIsDecidesNotWhatItIsCalled) {
    GltfBuilder builder = rich_file();
    builder.json["images"][0]["mimeType"] = "image/jpeg";  // it is a PNG
    EXPECT_EQ(load(builder).textures.at(0).levels.at(0).at(0, 0), (Rgba8{1, 2, 3, 4}));
    // One grey pixel of value 0x8000.
    const std::string sixteen_bits(
        "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001\000\000\000\001"
        "\020\000\000\000\000\152\356\107\026\000\000\000\013\111\104\101\124\170\234\143\150\140\000\000"
        "\001\003\000\201\076\114\305\223\000\000\000\000\111\105\116\104\256\102\140\202",
        68);
    builder.json["images"][0]["bufferView"] = builder.add_view(sixteen_bits.data(), sixteen_bits.size());
    EXPECT_EQ(load(builder).textures.at(0).levels.at(0).pixels, (std::vector<Rgba8>{{128, 128, 128, 255}}))
        << "scaled to 8 bits";
    const std::string no_pixels("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\0\0\0\0\0\x08\x06\0\0\0", 29);
    builder.json["images"][0]["bufferView"] = builder.add_view(no_pixels.data(), no_pixels.size());
    EXPECT_TRUE(has_note(load(builder), "by white, as it is broken"));
}

TEST(G23, BlindingEmissionIsLimited) {
    GltfBuilder builder = rich_file();
    builder.json["materials"][0]["emissiveFactor"] = {1e9, 0, 0};
    const Scene scene = load(builder);
    EXPECT_TRUE(has_note(scene, "limited material factors outside of 0..1"));
    EXPECT_EQ(scene.materials.at(0).emission, Vec3(1, 0, 0));
    builder.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 1e9}};
    EXPECT_TRUE(has_note(load(builder), "limited the strength of an emission to 0..1000"));
    EXPECT_LT(load(builder).materials.at(0).emission.x, 20.0f);
}

TEST(G24, CamerasWithOddPlanesAreUsedAndOthersFitted) {
    GltfBuilder builder = rich_file();
    json& perspective = builder.json["cameras"][0]["perspective"];
    perspective = {{"yfov", 1.0}, {"znear", 10}, {"zfar", 0.1}, {"aspectRatio", 0}};
    const Scene scene = load(builder);
    ASSERT_TRUE(scene.camera.has_value()) << "planes and aspect are not what this camera has";
    perspective["yfov"] = 3.15;
    EXPECT_FALSE(load(builder).camera.has_value());
    EXPECT_TRUE(is_valid(flat_of(builder).camera)) << "fitted to the bounds";
}

TEST(G26, DuplicateKeysUnknownPropertiesAndLongExtras) {
    const std::string text = one_triangle().text();
    EXPECT_EQ(load_error("{\"meshes\":[],\"nodes\":5,\"colour\":{\"a\":[null]}," + text.substr(1)), "")
        << "of a key that comes twice the last counts";
    EXPECT_EQ(load_error("{\"extras\":\"" + std::string(20'000'000, 'x') + "\"," + text.substr(1)), "");
}

TEST(G27, NamesAreFitForOneLine) {
    const std::string evil = "a\x1b[31m\n\tb\x7f\xc2\x9b <script>";
    GltfBuilder builder = rich_file();
    builder.json["materials"][0]["name"] = evil;
    builder.json["meshes"][0]["name"] = evil;
    builder.json["images"][0]["name"] = evil;
    builder.json["images"][0].erase("bufferView");
    builder.json["images"][0]["uri"] = "gone\x1b.png";
    builder.json["extensionsUsed"] = {evil};
    const Scene scene = load_text(builder.text(), "sc\x1b[1mene.gltf");
    EXPECT_EQ(scene.name, "sc?[1mene.gltf");
    EXPECT_EQ(scene.material_names.at(0), "a?[31m??b?? <script>");
    EXPECT_EQ(scene.meshes.at(0).name, "a?[31m??b?? <script>");
    EXPECT_TRUE(has_note(scene, "replaced image 0 (gone?.png) by white"));
    EXPECT_TRUE(has_note(scene, "ignored extension a?[31m??b?? <script>"));
    builder.json["materials"][0]["name"] = std::string(1'000'000, 'n');
    EXPECT_LT(load(builder).material_names.at(0).size(), 200u);
}

TEST(G27, ManyDifferentRemarksAreCut) {
    GltfBuilder builder = one_triangle();
    for (int i = 0; i < 100'000; ++i) builder.json["extensionsUsed"].push_back("X_" + std::to_string(i));
    const Scene scene = load(builder);
    EXPECT_EQ(scene.notes.size(), 101u);
    EXPECT_EQ(scene.notes.back(), "and 99900 more of such remarks");
}

}  // namespace
}  // namespace kd
