#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

TEST(G06, ASymbolicLinkMustNotLeadOut) {
    const auto folder = scratch_folder();
    const auto inside = folder / "inside";
    std::filesystem::create_directory(inside);
    GltfBuilder builder = one_triangle();
    builder.json["buffers"] = {{{"byteLength", builder.bytes.size()}, {"uri", "data.bin"}}};
    put_bytes(inside / "scene.gltf", builder.text());
    put_bytes(folder / "outside.bin", builder.bytes);
    std::filesystem::create_symlink(folder / "outside.bin", inside / "data.bin");
    EXPECT_TRUE(holds(error_of([&] { (void)load_gltf(inside / "scene.gltf"); }),
                      "/buffers/0/uri: 'data.bin' leads out of the scene's folder through a symbolic link"));
    std::filesystem::remove(inside / "data.bin");
    put_bytes(inside / "real.bin", builder.bytes);
    std::filesystem::create_symlink("real.bin", inside / "data.bin");
    EXPECT_EQ(load_gltf(inside / "scene.gltf").meshes.size(), 1u) << "a link within the folder is fine";
}

TEST(GltfBuffer, FilesBesideTheSceneMayBeLongerAndHaveOddNames) {
    const auto folder = scratch_folder();
    std::filesystem::create_directory(folder / "sub");
    GltfBuilder builder = one_triangle();
    builder.json["buffers"] = {{{"byteLength", builder.bytes.size()}, {"uri", "./sub/a%20b+%c3%bc.bin"}}};
    put_bytes(folder / "scene.gltf", builder.text());
    put_bytes(folder / "sub" / "a b+\xc3\xbc.bin", builder.bytes + "trailing");
    EXPECT_EQ(load_gltf(folder / "scene.gltf").meshes.at(0).positions[1], Vec3(1, 0, 0));
    put_bytes(folder / "sub" / "a b+\xc3\xbc.bin", builder.bytes.substr(1));
    EXPECT_TRUE(holds(error_of([&] { (void)load_gltf(folder / "scene.gltf"); }), "/buffers/0/byteLength: says "));
}

TEST(Glb, LoadsLikeText) {
    const Scene text = load(one_triangle());
    const Scene binary = load_text(one_triangle().glb(), "scene.glb");
    EXPECT_EQ(binary.meshes.at(0).positions, text.meshes.at(0).positions);
    EXPECT_EQ(binary.meshes[0].indices, text.meshes[0].indices);
}

TEST(G03, TrailingBytesAreIgnoredWithANote) {
    EXPECT_TRUE(
        has_note(load_text(one_triangle().glb() + "more", "scene.glb"), "ignored bytes after the end of the GLB"));
}

TEST(G03, EveryLengthIsChecked) {
    const std::string good = one_triangle().glb();
    const auto json_size = static_cast<unsigned char>(good[12]) | static_cast<unsigned char>(good[13]) << 8;
    const std::size_t bin = 20 + static_cast<std::size_t>(json_size);
    const auto error_with = [&](std::size_t at, const std::string& replacement) {
        std::string file = good;
        return load_error(file.replace(at, replacement.size(), replacement), "scene.glb");
    };
    EXPECT_TRUE(holds(error_with(4, GltfBuilder::word(1)), "GLB version 1 is not supported"));
    EXPECT_TRUE(holds(error_with(4, GltfBuilder::word(3)), "GLB version 3 is not supported"));
    EXPECT_TRUE(holds(error_with(8, GltfBuilder::word(good.size() + 4)), "GLB header: says"));
    EXPECT_TRUE(holds(error_with(8, GltfBuilder::word(0xffffffff)), "GLB header: says 4294967295 bytes"));
    EXPECT_TRUE(holds(error_with(8, GltfBuilder::word(3)), "GLB header: says 3 bytes"));
    EXPECT_TRUE(holds(error_with(8, GltfBuilder::word(16)), "GLB JSON chunk: missing"));
    EXPECT_TRUE(holds(error_with(12, GltfBuilder::word(0xfffffff0)), "GLB JSON chunk: longer than the file"));
    EXPECT_TRUE(holds(error_with(12, GltfBuilder::word(0)), "GLB JSON chunk: empty"));
    EXPECT_TRUE(holds(error_with(16, "BIN"), "GLB JSON chunk: another kind of chunk"));
    EXPECT_TRUE(holds(error_with(bin, GltfBuilder::word(0x7ffffffc)), "GLB BIN chunk: longer than the file"));
    EXPECT_TRUE(holds(error_with(bin, GltfBuilder::word(6)), "GLB BIN chunk: its length must be a multiple of 4"));
    EXPECT_TRUE(holds(error_with(bin + 4, "JSON"), "GLB BIN chunk: another kind of chunk"));
    EXPECT_TRUE(holds(error_with(0, "GLTF"), "GLB header: bad magic 'GLTF'; a GLB begins with 'glTF'"));
}

}  // namespace
}  // namespace kd
