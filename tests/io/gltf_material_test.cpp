#include <cmath>

#include "renderer/io/gltf_surface.h"
#include "renderer/io/png.h"
#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

using nlohmann::json;

void expect_near(Vec3 got, glm::dvec3 expected, double tolerance = 1e-6) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(double(got[i]), expected[i], tolerance) << "channel " << i;
}

TEST(Surface, EncodesAndDecodesSrgb) {
    expect_near(Vec3(srgb_encoded({0.0, 0.5, 1.0})), {0.0, 0.7353569830524495, 1.0});
    expect_near(Vec3(srgb_encoded({0.001, 0.0031308, 0.2})), {0.01292, 0.04045, 0.484529});
    for (double x = 0.0; x <= 1.0; x += 1.0 / 64.0) {
        EXPECT_NEAR(srgb_decoded(srgb_encoded(glm::dvec3(x))).x, x, 1e-6);
    }
}

TEST(Surface, ARoughDielectricOnlyScatters) {
    const Material m = to_material(metallic_roughness({0.5, 0.2, 1.0}, 0.0, 1.0), 3);
    expect_near(m.diffuse, srgb_encoded({0.5, 0.2, 1.0}));
    expect_near(m.specular, glm::dvec3(0.0));
    EXPECT_EQ(m.reflectance, Vec3(0.0f));
    EXPECT_EQ(m.shininess, 2.0f);
    EXPECT_EQ(m.texture, 3);
}

TEST(Surface, OrdinaryDielectricsCallForNoReflection) {
    for (const double roughness : {0.5, 0.6, 0.8, 1.0}) {
        EXPECT_EQ(to_material(metallic_roughness(glm::dvec3(0.8), 0.0, roughness), -1).reflectance, Vec3(0.0f));
    }
    // Polished glass or plastic does: 4 %.
    expect_near(to_material(metallic_roughness(glm::dvec3(0.8), 0.0, 0.0), -1).reflectance, glm::dvec3(0.04));
}

TEST(Surface, APolishedMetalIsAMirrorOfItsColour) {
    const glm::dvec3 gold(1.0, 0.766, 0.336);
    const Material m = to_material(metallic_roughness(gold, 1.0, 0.0), -1);
    expect_near(m.diffuse, glm::dvec3(0.0));
    expect_near(m.specular, srgb_encoded(gold));
    expect_near(m.reflectance, srgb_encoded(gold));
    EXPECT_EQ(m.shininess, 1024.0f);
}

TEST(Surface, ARoughMetalIsNotBlack) {
    const Material m = to_material(metallic_roughness(glm::dvec3(0.5), 1.0, 1.0), -1);
    expect_near(m.diffuse, srgb_encoded(glm::dvec3(0.5)));
    EXPECT_EQ(m.reflectance, Vec3(0.0f));
}

TEST(Surface, ShininessFollowsRoughness) {
    // alpha = 0.25, 2 / 0.0625 - 2
    EXPECT_NEAR(to_material(metallic_roughness(glm::dvec3(1), 0, 0.5), -1).shininess, 30.0, 1e-4);
    float last = 2000.0f;
    for (double roughness = 0.0; roughness <= 1.0; roughness += 0.05) {
        const Material m = to_material(metallic_roughness(glm::dvec3(1), 0.5, roughness), -1);
        EXPECT_LE(m.shininess, last);
        EXPECT_GE(m.shininess, 2.0f);
        EXPECT_LE(m.shininess, 1024.0f);
        last = m.shininess;
    }
}

TEST(Surface, GlossyMirrorFromSpecularGlossiness) {
    const Material mirror = to_material(specular_glossiness(glm::dvec3(0.0), glm::dvec3(1.0), 1.0), -1);
    expect_near(mirror.reflectance, glm::dvec3(1.0));
    const Material plastic = to_material(specular_glossiness(glm::dvec3(0.5), glm::dvec3(0.04), 0.3), -1);
    expect_near(plastic.diffuse, srgb_encoded(glm::dvec3(0.5)));
    EXPECT_EQ(plastic.reflectance, Vec3(0.0f));
}

/// One triangle with this material.
GltfBuilder with_material(const json& material) {
    GltfBuilder builder = one_triangle();
    builder.json["materials"] = {material};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

/// Adds texture 0 that shows this image, held in the buffer.
void add_texture(GltfBuilder& builder, const std::string& encoded, const char* mime = "image/png") {
    const std::size_t view = builder.add_view(encoded.data(), encoded.size());
    builder.json["images"].push_back({{"bufferView", view}, {"mimeType", mime}});
    builder.json["textures"].push_back({{"source", builder.json["images"].size() - 1}});
}

std::string png_of(const std::vector<Rgba8>& pixels, int width) {
    Image<Rgba8> image(width, static_cast<int>(pixels.size()) / width);
    image.pixels = pixels;
    const auto path = scratch_folder() / "image.png";
    write_png(path, image);
    return get_bytes(path);
}

const json textured = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}};

TEST(G21, DefaultsAreThoseOfGltf) {
    const Scene scene = load(one_triangle());
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.material_names, std::vector<std::string>{"default"});
    expect_near(scene.materials[0].diffuse, glm::dvec3(1.0));
    EXPECT_EQ(scene.materials[0].texture, -1);
}

TEST(GltfMaterial, ReadsFactorsAndName) {
    const Scene scene = load(with_material(
        {{"name", "red\x1b"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 0, 0.5}}, {"metallicFactor", 0}, {"roughnessFactor", 0.75}}}}));
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.material_names[0], "red?");
    expect_near(scene.materials[0].diffuse, srgb_encoded({0.5, 0.25, 0.0}));
    expect_near(scene.materials[0].specular, 0.25 * srgb_encoded(glm::dvec3(0.04)));
}

TEST(G23, LimitsFactorsOutOfRange) {
    const Scene scene =
        load(with_material({{"pbrMetallicRoughness",
                             {{"baseColorFactor", {2, -1, 1, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 7}}}}));
    expect_near(scene.materials.at(0).diffuse, {1.0, 0.0, 1.0});
    EXPECT_TRUE(has_note(scene, "limited material factors outside of 0..1"));
}

TEST(G21, UnknownMaterialsBecomeTheDefault) {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["material"] = 4;
    const Scene scene = load(builder);
    EXPECT_EQ(scene.material_names.at(0), "default");
    EXPECT_TRUE(has_note(scene, "replaced 1 material that the file does not have by the default"));
}

TEST(GltfMaterial, TellsWhatItDoesNotShow) {
    GltfBuilder builder =
        with_material({{"alphaMode", "BLEND"}, {"extensions", {{"KHR_materials_clearcoat", json::object()}}}});
    builder.json["extensionsUsed"] = {"KHR_materials_clearcoat"};
    const Scene scene = load(builder);
    EXPECT_TRUE(has_note(scene, "shown 1 transparent material as opaque"));
    EXPECT_TRUE(has_note(scene, "ignored extension KHR_materials_clearcoat"));
}

TEST(GltfMaterial, ReadsWhatIsEmitted) {
    GltfBuilder builder =
        with_material({{"emissiveFactor", {0.25, 1, 0}},
                       {"emissiveTexture", {{"index", 0}}},
                       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}}}}});
    builder.json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    add_texture(builder, png_of({{255, 0, 0, 255}, {0, 0, 0, 255}}, 2));
    const Scene scene = load(builder);
    expect_near(scene.materials.at(0).emission, srgb_encoded({0.5, 2.0, 0.0}));
    EXPECT_EQ(scene.materials[0].emission_texture, 0);
    EXPECT_EQ(scene.materials[0].texture, -1);
    EXPECT_EQ(scene.meshes.at(0).texture_coordinates, (std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_FALSE(has_note(scene, "ignored extension KHR_materials_emissive_strength"));
    // Without a factor the image is not asked for.
    builder.json["materials"][0].erase("emissiveFactor");
    EXPECT_TRUE(load(builder).textures.empty());
}

TEST(GltfMaterial, AnEmissiveTextureWithItsOwnCoordinatesCountsByItsMean) {
    GltfBuilder builder = with_material(
        {{"emissiveFactor", {1, 1, 1}},
         {"emissiveTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}}},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.json["extensionsUsed"] = {"KHR_texture_transform"};
    add_texture(builder, png_of({{255, 0, 0, 255}, {0, 0, 0, 255}}, 2));
    const Scene scene = load(builder);
    expect_near(scene.materials.at(0).emission, {0.5, 0.0, 0.0});
    EXPECT_EQ(scene.materials[0].emission_texture, -1);
    EXPECT_TRUE(has_note(scene, "replaced 1 emissive texture by its mean, as it has its own coordinates"));
}

TEST(GltfMaterial, ReadsSpecularGlossiness) {
    const Scene scene = load(with_material(
        {{"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {0.25, 0.5, 1, 1}}, {"specularFactor", {0, 0, 0}}, {"glossinessFactor", 0}}}}}}));
    expect_near(scene.materials.at(0).diffuse, srgb_encoded({0.25, 0.5, 1.0}));
    EXPECT_EQ(scene.materials[0].specular, Vec3(0.0f));
}

TEST(GltfTexture, KeepsStoredPixelsAndUv) {
    GltfBuilder builder = with_material(textured);
    const std::vector<Rgba8> pixels{{10, 20, 30, 40}, {255, 0, 1, 255}};
    add_texture(builder, png_of(pixels, 2));
    const Scene scene = load(builder);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].levels.at(0).pixels, pixels);
    EXPECT_EQ(scene.materials.at(0).texture, 0);
    EXPECT_EQ(scene.meshes.at(0).texture_coordinates, (std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(GltfTexture, LoadsFromAGlbAndOnceForTwoMaterials) {
    GltfBuilder builder = with_material(textured);
    add_texture(builder, png_of({{1, 2, 3, 4}}, 1));
    builder.json["textures"].push_back({{"source", 0}});
    builder.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
    builder.add_primitive({{"POSITION", 0}, {"TEXCOORD_0", 1}})["material"] = 1;
    const Scene scene = load_text(builder.glb(), "scene.glb");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures.at(0).levels.at(0).pixels, (std::vector<Rgba8>{{1, 2, 3, 4}}));
}

TEST(GltfTexture, UsesTheTextureCoordinatesItNames) {
    GltfBuilder builder = with_material(textured);
    add_texture(builder, png_of({{1, 2, 3, 4}}, 1));
    builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    Scene scene = load(builder);
    EXPECT_TRUE(scene.meshes.at(0).texture_coordinates.empty());
    EXPECT_TRUE(has_note(scene, "found no texture coordinates in 1 primitive with a texture"));
    const std::vector<Vec2> second{{5, 5}, {6, 5}, {5, 6}};
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = builder.add_vec2(second);
    scene = load(builder);
    EXPECT_EQ(scene.meshes.at(0).texture_coordinates, second);
}

TEST(GltfTexture, AppliesTheTextureTransform) {
    GltfBuilder builder = with_material(textured);
    add_texture(builder, png_of({{1, 2, 3, 4}}, 1));
    builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.25, 0.5}}, {"scale", {2, 4}}, {"rotation", std::acos(0.0)}};
    const Scene scene = load(builder);
    // A quarter turn takes u to -v and v to u.
    const std::vector<Vec2> expected{{0.25f, 0.5f}, {0.25f, -1.5f}, {4.25f, 0.5f}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(scene.meshes.at(0).texture_coordinates[i].x, expected[i].x, 1e-6);
        EXPECT_NEAR(scene.meshes.at(0).texture_coordinates[i].y, expected[i].y, 1e-6);
    }
}

TEST(GltfTexture, SamplersSayHowImagesGoOnAndWhetherTheyHaveMipMaps) {
    GltfBuilder builder = with_material(textured);
    add_texture(builder, png_of({{1, 2, 3, 4}, {5, 6, 7, 8}}, 2));
    const Scene plain = load(builder);
    EXPECT_EQ(plain.textures.at(0).wrap_x, KD_WRAP_REPEAT);
    EXPECT_EQ(plain.textures[0].levels.size(), 2u) << "no sampler leaves the choice";
    builder.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9987}}};
    builder.json["textures"][0]["sampler"] = 0;
    Scene scene = load(builder);
    EXPECT_EQ(scene.textures.at(0).wrap_x, KD_WRAP_CLAMP);
    EXPECT_EQ(scene.textures[0].wrap_y, KD_WRAP_MIRROR);
    EXPECT_EQ(scene.textures[0].levels.size(), 2u);
    EXPECT_TRUE(scene.notes.empty());
    for (const int without : {9728, 9729}) {
        builder.json["samplers"][0]["minFilter"] = without;
        EXPECT_EQ(load(builder).textures.at(0).levels.size(), 1u);
    }
    builder.json["samplers"][0]["magFilter"] = 9728;
    EXPECT_TRUE(has_note(load(builder), "smoothed 1 texture whose texels should be seen"));
}

TEST(GltfTexture, OneImageMayBeSampledInTwoWays) {
    GltfBuilder builder = with_material(textured);
    add_texture(builder, png_of({{1, 2, 3, 4}}, 1));
    builder.json["samplers"] = {{{"wrapS", 33071}}};
    builder.json["textures"].push_back({{"source", 0}, {"sampler", 0}});
    builder.json["materials"][0]["normalTexture"] = {{"index", 1}, {"scale", 0.5}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.materials.at(0).texture, 0);
    EXPECT_EQ(scene.materials[0].normal_texture, 1);
    EXPECT_EQ(scene.materials[0].normal_scale, 0.5f);
    EXPECT_EQ(scene.textures[1].wrap_x, KD_WRAP_CLAMP);
    builder.json["materials"][0]["normalTexture"]["texCoord"] = 1;
    EXPECT_EQ(load(builder).materials.at(0).normal_texture, -1);
    EXPECT_TRUE(has_note(load(builder), "ignored 1 normal map, as it has its own coordinates"));
}

TEST(GltfMaterial, CutsOutWhatAMaskSays) {
    const auto cutoff = [](const json& material) { return load(with_material(material)).materials.at(0).alpha_cutoff; };
    EXPECT_EQ(cutoff({{"alphaMode", "OPAQUE"}, {"alphaCutoff", 0.25}}), 0.0f);
    EXPECT_EQ(cutoff({{"alphaMode", "MASK"}}), 0.5f) << "as the format has it";
    EXPECT_EQ(cutoff({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}}), 0.25f);
    const json half{{"baseColorFactor", {1, 1, 1, 0.5}}};
    EXPECT_EQ(cutoff({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}, {"pbrMetallicRoughness", half}}), 0.5f);
    const json none{{"baseColorFactor", {1, 1, 1, 0}}};
    EXPECT_GT(cutoff({{"alphaMode", "MASK"}, {"pbrMetallicRoughness", none}}), 1.0f) << "nothing is seen";
}

TEST(GltfTexture, TheMeanStandsForAMetallicRoughnessTexture) {
    GltfBuilder builder =
        with_material({{"pbrMetallicRoughness",
                        {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}, {"metallicRoughnessTexture", {{"index", 0}}}}}});
    add_texture(builder, png_of({{0, 0, 255, 255}, {9, 102, 255, 255}}, 2));  // roughness 0 and 0.4, metal
    const Scene scene = load(builder);
    EXPECT_TRUE(scene.textures.empty());
    const Material expected = to_material(metallic_roughness(glm::dvec3(0.5), 1.0, 0.2), -1);
    expect_near(scene.materials.at(0).reflectance, glm::dvec3(expected.reflectance));
    EXPECT_TRUE(has_note(scene, "replaced 1 metallic-roughness texture by the mean of each"));
}

TEST(GltfTexture, ReadsJpeg) {
    // 16 x 8 pixels, the left half of one colour, the right half of another.
    GltfBuilder builder = with_material(textured);
    add_texture(builder, get_bytes(std::string(KD_SOURCE_DIR) + "/tests/fixtures/io/two_colours.jpg"), "image/jpeg");
    const Scene scene = load(builder);
    const Image<Rgba8>& image = scene.textures.at(0).levels.at(0);
    ASSERT_EQ(image.width, 16);
    ASSERT_EQ(image.height, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Rgba8 expected = x < 8 ? Rgba8{200, 30, 40, 255} : Rgba8{20, 60, 220, 255};
            EXPECT_NEAR(image.at(x, y).r, expected.r, 3);
            EXPECT_NEAR(image.at(x, y).g, expected.g, 3);
            EXPECT_NEAR(image.at(x, y).b, expected.b, 3);
            EXPECT_EQ(image.at(x, y).a, 255);
        }
    }
    EXPECT_TRUE(scene.notes.empty());
}

TEST(G22, BrokenImagesBecomeWhite) {
    const std::string good = png_of({{1, 2, 3, 4}}, 1);
    const std::string huge("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xff\xff\0\0\xff\xff\x08\x06\0\0\0", 29);
    const struct {
        std::string bytes;
        const char* note;
    } cases[] = {{good.substr(0, good.size() - 20), "as it is broken"},
                 {good.substr(0, 12), "as it is broken"},
                 {huge, "as it is too large with 65535 x 65535 pixels"},
                 {"GIF89a no image", "as it is neither PNG nor JPEG"},
                 {"\xff\xd8\xff", "as it is broken"},
                 {std::string("\xff\xd8\xff\xe0\0\0\xff\xc0\0\x0b\x08\xff\xff\xff\xff\x01", 16), "as it is "}};
    for (const auto& c : cases) {
        GltfBuilder builder = with_material(textured);
        add_texture(builder, c.bytes);
        const Scene scene = load(builder);
        ASSERT_EQ(scene.textures.size(), 1u);
        EXPECT_EQ(scene.textures[0].levels.at(0).pixels, (std::vector<Rgba8>{{255, 255, 255, 255}}));
        EXPECT_TRUE(has_note(scene, c.note)) << c.note;
    }
}

TEST(G22, MissingFilesBecomeWhite) {
    GltfBuilder builder = with_material(textured);
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"uri", "none.png"}}};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.textures.at(0).levels.at(0).pixels, (std::vector<Rgba8>{{255, 255, 255, 255}}));
    EXPECT_TRUE(has_note(scene, "replaced image 0 (none.png) by white, as it cannot be read"));
}

TEST(G21, TexturesWithoutImagesAreIgnored) {
    GltfBuilder builder = with_material(textured);
    const Scene scene = load(builder);
    EXPECT_EQ(scene.materials.at(0).texture, -1);
    EXPECT_TRUE(has_note(scene, "ignored 1 texture without an image that can be shown"));
}

}  // namespace
}  // namespace kd
