// Bad files that are refused, by the numbers of docs/stability.md, "Bad input". What only one value of the JSON makes
// bad is in gltf_error_test.cpp; what a format's own tests cover stays there under its number.
#include "tests/io/gltf_samples.h"

namespace kd {
namespace {

using nlohmann::json;

/// The error in decoding under `limits`, from the file's name on.
std::string error_under(const GltfLimits& limits, const GltfBuilder& builder) {
    return error_of([&] { (void)decode_gltf(builder.text(), "scene.gltf", limits); });
}

TEST(G01, AFileThatCannotBeRead) {
    // Root may open any file, and still cannot read page 0 of a process.
    if (!std::filesystem::exists("/proc/self/mem")) GTEST_SKIP() << "no /proc on this machine";
    EXPECT_TRUE(holds(error_of([] { (void)load_gltf("/proc/self/mem"); }), "cannot read /proc/self/mem: "));
}

TEST(G01, ThreeBytes) {
    EXPECT_TRUE(holds(load_error("glT", "scene.glb"), "GLB header: bad magic 'glT'"));
    EXPECT_EQ(load_error("glTF", "scene.glb"), "scene.glb: GLB header: cut off");
    EXPECT_EQ(load_error("{\"a", "scene.gltf"), "scene.gltf: line 1, column 4: not valid JSON, or the file is cut off");
}

TEST(G03, BytesThatAreNeitherNameTheMagic) {
    EXPECT_EQ(load_error("\x89PNG\r\n\x1a\n and so on", "scene.glb"),
              "scene.glb: GLB header: bad magic '?PNG'; a GLB begins with 'glTF'");
    EXPECT_TRUE(holds(load_error(std::string(64, '\1'), "scene.GLB"), "GLB header: bad magic '?"));
    EXPECT_TRUE(holds(load_error("\xef\xbb\xbf  ", "scene.glb"), "bad magic")) << "a byte order mark and nothing more";
    EXPECT_EQ(load_error("\xef\xbb\xbf \n" + one_triangle().text(), "scene.glb"), "") << "text under the other name";
    EXPECT_EQ(load_error(one_triangle().glb(), "scene.gltf"), "") << "and the other way round";
}

TEST(G05, ExtensionsThatAreNotRequiredAreIgnoredAndTold) {
    GltfBuilder builder = one_triangle();
    builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression", "X_unknown\x1b[31m"};
    const Scene scene = load(builder);
    EXPECT_TRUE(has_note(scene, "ignored extension KHR_draco_mesh_compression"));
    EXPECT_TRUE(has_note(scene, "ignored extension X_unknown?[31m"));
}

TEST(G05, RequiredExtensionsComeBeforeAllElse) {
    GltfBuilder builder = one_triangle();
    builder.json["extensionsRequired"] = {"X_future"};
    builder.json["meshes"] = "in another form";
    EXPECT_EQ(load_error(builder.text()),
              "scene.gltf: /extensionsRequired/0: extension X_future is not supported; export without it");
}

TEST(G06, AFolderThatIsASymbolicLinkMustNotLeadOut) {
    const auto folder = scratch_folder();
    std::filesystem::create_directories(folder / "inside");
    std::filesystem::create_directories(folder / "outside");
    GltfBuilder builder = one_triangle();
    put_bytes(folder / "outside" / "data.bin", builder.bytes);
    std::filesystem::create_directory_symlink(folder / "outside", folder / "inside" / "sub");
    builder.json["buffers"] = {{{"byteLength", builder.bytes.size()}, {"uri", "sub/data.bin"}}};
    put_bytes(folder / "inside" / "scene.gltf", builder.text());
    EXPECT_TRUE(holds(error_of([&] { (void)load_gltf(folder / "inside" / "scene.gltf"); }),
                      "/buffers/0/uri: 'sub/data.bin' leads out of the scene's folder through a symbolic link"));
}

TEST(G06, SeveralBuffersMayBePartsOfOneFile) {
    const auto folder = scratch_folder();
    GltfBuilder builder = one_triangle();
    put_bytes(folder / "data.bin", builder.bytes);
    for (const std::size_t length : {builder.bytes.size(), std::size_t(36), builder.bytes.size()})
        builder.json["buffers"].push_back({{"byteLength", length}, {"uri", "data.bin"}});
    builder.json["bufferViews"][0]["buffer"] = 1;
    put_bytes(folder / "scene.gltf", builder.text());
    EXPECT_EQ(load_gltf(folder / "scene.gltf").meshes.at(0).positions.size(), 3u);
}

TEST(G07, DataShorterThanItSays) {
    GltfBuilder builder = one_triangle();
    builder.json["buffers"] = {
        {{"byteLength", builder.bytes.size()}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
    EXPECT_EQ(load_error(builder.text()), "scene.gltf: /buffers/0/byteLength: says 60 bytes, there are 3");
}

TEST(G08, NumbersBeyondDouble) {
    std::string text = one_triangle().text();
    const std::size_t at = text.find("\"byteLength\":60");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(load_error(text.replace(at + 13, 2, "1e309")), "scene.gltf: the JSON holds a number that is too large");
}

TEST(G08, TheLimitIsThatOfAllBuffersTogether) {
    GltfBuilder builder = one_triangle();
    const std::uint64_t half = std::uint64_t(1) << 30;
    for (int i = 0; i < 3; ++i) builder.json["buffers"].push_back({{"byteLength", half}, {"uri", "none.bin"}});
    EXPECT_EQ(load_error(builder.text()),
              "scene.gltf: /buffers/2/byteLength: the buffers are larger than the limit of 2147483648 bytes");
}

TEST(G22, ManyImagesInFewBytesAreRefused) {
    // Each takes memory of its own, though all lie in the same bytes.
    GltfBuilder builder = rich_file();
    for (int i = 0; i < 100; ++i) builder.json["images"].push_back(builder.json["images"][0]);
    const std::string error = error_under({.image_bytes = 2000}, builder);
    EXPECT_TRUE(holds(error, "/images/")) << error;
    EXPECT_TRUE(holds(error, "the images are larger than the limit of 2000 bytes")) << error;
    EXPECT_EQ(error_under({}, builder), "");
}

TEST(G26, ManyValuesAreRefusedBeforeTheyAreParsed) {
    GltfBuilder builder = one_triangle();
    builder.json["extras"] = json(std::vector<int>(10'000, 1));
    EXPECT_TRUE(holds(error_under({.json_values = 10'000}, builder), "JSON values; the limit is 10000"));
    EXPECT_EQ(error_under({.json_values = 20'000}, builder), "");
}

TEST(G28, InstancesWithoutTrianglesCountToo) {
    // A mesh of many primitives shown by many nodes: their product, from a file of their sum.
    GltfBuilder builder;
    const std::size_t corner = builder.add_vec3({{0, 0, 0}});
    builder.add_primitive({{"POSITION", corner}});
    for (int i = 0; i < 10'000; ++i) {
        builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", corner}}}});
        builder.json["nodes"].push_back({{"mesh", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    EXPECT_TRUE(holds(load_error(builder.text()), "instances of primitives; the limit is 5000000"));
}

TEST(G28, AMeshOfManyUnusedPositionsIsShownOftenInNoTime) {
    // A million positions, of which one triangle is made: bounds come from the triangle's corners.
    GltfBuilder builder;
    std::vector<Vec3> positions(1'000'000, Vec3(1e6f));
    positions[1] = {1, 0, 0};
    positions[2] = {0, 1, 0};
    positions[0] = {0, 0, 0};
    builder.add_primitive({{"POSITION", builder.add_vec3(positions)}})["indices"] = builder.add_indices({0, 1, 2});
    for (int i = 0; i < 100'000; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    EXPECT_EQ(load_text(builder.glb(), "scene.glb").instances.size(), 100'001u);
}

}  // namespace
}  // namespace kd
