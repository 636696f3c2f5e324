#include "tests/io/gltf_builder.h"

namespace kd {
namespace {

using nlohmann::json;

/// A change to a good file: JSON pointer and new value (nothing: removed), and the error that it must end in.
struct Fault {
    const char* name;
    const char* pointer;
    json value;
    const char* error;  // after "scene.gltf: "
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

std::string name_of_fault(const testing::TestParamInfo<Fault>& test) { return test.param.name; }

// Instantiated below under the numbers of docs/stability.md, "Bad input".
class GltfFault : public testing::TestWithParam<Fault> {};

/// Indexed triangle with a material and an image, so that every part of the format is there to be broken.
json good_document() {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.add_indices({0, 1, 2});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["materials"] = {{{"name", "m"}}};
    const std::vector<std::uint16_t> at{1};
    const std::vector<Vec3> to{{0, 0, 0}};
    builder.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", builder.add_view(at.data(), 2)}, {"componentType", 5123}}},
        {"values", {{"bufferView", builder.add_view(to.data(), 12)}}}};
    builder.json["images"] = {{{"uri", "x.png"}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    return json::parse(builder.text());
}

TEST_P(GltfFault, IsToldInOneLine) {
    const Fault& fault = GetParam();
    json document = good_document();
    ASSERT_EQ(load_error(document.dump()), "") << "the file must be good before it is broken";
    const json operation = {
        {"op", fault.value.is_null() ? "remove" : "add"}, {"path", fault.pointer}, {"value", fault.value}};
    document = document.patch(json::array({operation}));
    const std::string error = load_error(document.dump());
    EXPECT_TRUE(error.starts_with(std::string("scene.gltf: ") + fault.error)) << error;
}

const json nothing;

INSTANTIATE_TEST_SUITE_P(
    Structure, GltfFault,
    testing::Values(Fault{"MeshesNoList", "/meshes", json::object(), "/meshes: must be a list"},
                    Fault{"MeshNoObject", "/meshes/0", 5, "/meshes/0: must be an object"},
                    Fault{"NoPrimitives", "/meshes/0/primitives", nothing, "/meshes/0/primitives: missing"},
                    Fault{"AttributesNoObject", "/meshes/0/primitives/0/attributes", json::array(),
                          "/meshes/0/primitives/0/attributes: must be an object"},
                    Fault{"NoSuchAccessor", "/meshes/0/primitives/0/attributes/POSITION", 9,
                          "/meshes/0/primitives/0/attributes/POSITION: 9 is not one of the 3 accessors"},
                    Fault{"NegativeAccessor", "/meshes/0/primitives/0/indices", -1,
                          "/meshes/0/primitives/0/indices: -1 is not one of the 3 accessors"},
                    Fault{"HugeAccessor", "/meshes/0/primitives/0/indices", 4294967296,
                          "/meshes/0/primitives/0/indices: 4294967296 is not one of the 3 accessors"},
                    Fault{"FractionalAccessor", "/meshes/0/primitives/0/indices", 1.5,
                          "/meshes/0/primitives/0/indices: this is not"},
                    Fault{"OddAttributeName", "/meshes/0/primitives/0/attributes/a~1b~0\n", -1,
                          "/meshes/0/primitives/0/attributes/a~1b~0?: -1 is not"},
                    Fault{"NoSuchMesh", "/nodes/0/mesh", 1, "/nodes/0/mesh: 1 is not one of the 1 meshes"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G04, GltfFault,
    testing::Values(Fault{"NoAsset", "/asset", nothing, "/asset: missing"},
                    Fault{"NoVersion", "/asset/version", nothing, "/asset/version: missing"},
                    Fault{"VersionIsNumber", "/asset/version", 2.0, "/asset/version: must be text"},
                    Fault{"Version1", "/asset/version", "1.0", "/asset/version: '1.0' is not supported"},
                    Fault{"MinVersion", "/asset/minVersion", "2.1", "/asset/minVersion: '2.1' is not supported"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G05, GltfFault,
    testing::Values(
        Fault{"Draco", "/extensionsRequired", json::array({"KHR_texture_transform", "KHR_draco_mesh_compression"}),
              "/extensionsRequired/1: extension KHR_draco_mesh_compression is not supported"},
        Fault{"Meshopt", "/extensionsRequired", json::array({"EXT_meshopt_compression"}),
              "/extensionsRequired/0: extension EXT_meshopt_compression is not supported"},
        Fault{"TerminalEscape", "/extensionsRequired", json::array({"\x1b[2J\n"}),
              "/extensionsRequired/0: extension ?[2J? "},
        Fault{"ExtensionsNoList", "/extensionsRequired", json::object(), "/extensionsRequired: must be a list"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G06, GltfFault,
    testing::Values(
        Fault{"NoBufferUri", "/buffers/0/uri", nothing, "/buffers/0/uri: missing"},
        Fault{"MissingFile", "/buffers/0/uri", "none.bin", "/buffers/0/uri: cannot read "},
        Fault{"ParentFolder", "/buffers/0/uri", "../../etc/passwd",
              "/buffers/0/uri: '../../etc/passwd' leads out of the scene's folder"},
        Fault{"HiddenParent", "/buffers/0/uri", "a/%2e%2E/%2e./x", "/buffers/0/uri: 'a/%2e%2E/%2e./x' leads out of"},
        Fault{"Absolute", "/buffers/0/uri", "/etc/passwd", "/buffers/0/uri: '/etc/passwd' an absolute path"},
        Fault{"Web", "/buffers/0/uri", "http://example.org/a.bin",
              "/buffers/0/uri: 'http://example.org/a.bin' not a file"},
        Fault{"FileUri", "/buffers/0/uri", "FILE:///etc/passwd", "/buffers/0/uri: 'FILE:///etc/passwd' not a file"},
        Fault{"Drive", "/buffers/0/uri", "C:/x.bin", "/buffers/0/uri: 'C:/x.bin' not a file"},
        Fault{"Backslash", "/buffers/0/uri", "..\\x.bin", "/buffers/0/uri: '..\\x.bin' holds a backslash"},
        Fault{"Nul", "/buffers/0/uri", std::string("a\0b", 3), "/buffers/0/uri: 'a?b' holds a NUL"},
        Fault{"EscapedNul", "/buffers/0/uri", "a%00b", "/buffers/0/uri: 'a%00b' holds a NUL"},
        Fault{"ImageOutside", "/images/0/uri", "../x.png", "/images/0/uri: '../x.png' leads out of the scene's folder"},
        Fault{"FolderItself", "/buffers/0/uri", "./", "/buffers/0/uri: './' "}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G07, GltfFault,
    testing::Values(Fault{"BadBase64", "/buffers/0/uri", "data:application/octet-stream;base64,?*?*",
                          "/buffers/0/uri: 'data:application/octet-stream;base64,?*?*' cannot be decoded"},
                    Fault{"OtherData", "/buffers/0/uri", "data:application/x-other,abc",
                          "/buffers/0/uri: 'data:application/x-other,abc'"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G08, GltfFault,
    testing::Values(
        Fault{"ZeroBuffer", "/buffers/0/byteLength", 0, "/buffers/0/byteLength: must be 1 or more"},
        Fault{"NegativeBuffer", "/buffers/0/byteLength", -1, "/buffers/0/byteLength: must be a whole number"},
        Fault{"LongBuffer", "/buffers/0/byteLength", 1000, "/buffers/0/byteLength: says 1000 bytes, there are "},
        Fault{"HugeBuffer", "/buffers/0/byteLength", 9223372036854775808u,
              "/buffers/0/byteLength: the buffers are larger than the limit of 2147483648 bytes"},
        Fault{"TwoGiB", "/buffers/0/byteLength", 2147483648u,
              "/buffers/0/byteLength: says 2147483648 bytes, there are "},
        Fault{"FractionalBuffer", "/buffers/0/byteLength", 36.5, "/buffers/0/byteLength: must be a whole number"},
        Fault{"BufferIs1e300", "/buffers/0/byteLength", 1e300, "/buffers/0/byteLength: must be a whole number"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G09, GltfFault,
    testing::Values(
        Fault{"ViewWraps", "/bufferViews/0/byteOffset", 18446744073709551600u,
              "/bufferViews/0/byteLength: 36 bytes from"},
        Fault{"ViewTooLong", "/bufferViews/0/byteLength", 10000, "/bufferViews/0/byteLength: 10000 bytes from 0 on"},
        Fault{"ViewEmpty", "/bufferViews/0/byteLength", 0, "/bufferViews/0/byteLength: must be 1 or more"},
        Fault{"NoSuchBuffer", "/bufferViews/0/buffer", 1, "/bufferViews/0/buffer: 1 is not one of the 1 buffers"},
        Fault{"Stride1", "/bufferViews/0/byteStride", 1, "/bufferViews/0/byteStride: must be a multiple of 4"},
        Fault{"Stride256", "/bufferViews/0/byteStride", 256, "/bufferViews/0/byteStride: must be a multiple of 4"},
        Fault{"StrideTooSmall", "/bufferViews/0/byteStride", 8, "/bufferViews/0/byteStride: 8 is less than the 12"},
        Fault{"StrideTooLarge", "/bufferViews/0/byteStride", 16, "/accessors/0/byteOffset: 3 elements, 16 bytes apart"},
        Fault{"Stride255", "/bufferViews/0/byteStride", 255, "/bufferViews/0/byteStride: must be a multiple of 4"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G10, GltfFault,
    testing::Values(
        Fault{"BadOffset", "/accessors/0/byteOffset", 4,
              "/accessors/0/byteOffset: 3 elements, 12 bytes apart from 4 on"},
        Fault{"OffsetWraps", "/accessors/0/byteOffset", 18446744073709551612u, "/accessors/0/byteOffset: 3 elements"},
        Fault{"OffsetIsFraction", "/accessors/0/byteOffset", 0.5, "/accessors/0/byteOffset: must be a whole number"},
        Fault{"Misaligned", "/accessors/2/byteOffset", 1, "/accessors/2/byteOffset: "},
        Fault{"ZeroCount", "/accessors/0/count", 0, "/accessors/0/count: must be 1 or more"},
        Fault{"NegativeCount", "/accessors/0/count", -3, "/accessors/0/count: must be a whole number"},
        Fault{"CountWraps", "/accessors/0/count", 1537228672809129302u, "/accessors/0/byteOffset: 1537228672809129302"},
        Fault{"LargeCount", "/accessors/0/count", 4294967296, "/accessors/0/byteOffset: 4294967296 elements"},
        Fault{"IntComponents", "/accessors/0/componentType", 5124, "/accessors/0/componentType: 5124 is none of"},
        Fault{"DoubleComponents", "/accessors/0/componentType", 5130, "/accessors/0/componentType: 5130 is none of"},
        Fault{"Vec5", "/accessors/0/type", "VEC5", "/accessors/0/type: must be SCALAR, VEC2,"},
        Fault{"NoSuchView", "/accessors/0/bufferView", 8,
              "/accessors/0/bufferView: 8 is not one of the 5 bufferViews"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(G11, GltfFault,
                         testing::Values(Fault{"PositionsVec2", "/accessors/0/type", "VEC2",
                                               "/accessors/0: positions must be VEC3 of float"},
                                         Fault{"PositionsAreUint", "/accessors/0/componentType", 5125,
                                               "/accessors/0: positions must be VEC3 of float"}),
                         name_of_fault);

INSTANTIATE_TEST_SUITE_P(G12, GltfFault,
                         testing::Values(Fault{"IndicesAreFloat", "/meshes/0/primitives/0/indices", 1,
                                               "/accessors/1: indices must be SCALAR"}),
                         name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G15, GltfFault,
    testing::Values(
        Fault{"SparseTooMany", "/accessors/0/sparse/count", 4, "/accessors/0/sparse/count: must be from 1 to"},
        Fault{"SparseIndices", "/accessors/0/sparse/indices/byteOffset", 2, "/accessors/0/sparse/indices/byteOffset: "},
        Fault{"SparseValues", "/accessors/0/sparse/values/byteOffset", 4, "/accessors/0/sparse/values/byteOffset: "},
        Fault{"SparseOffsetWraps", "/accessors/0/sparse/values/byteOffset", 4294967296,
              "/accessors/0/sparse/values/byteOffset: must be a whole number from 0"},
        Fault{"SparseFloatIndices", "/accessors/0/sparse/indices/componentType", 5126,
              "/accessors/0/sparse/indices/componentType: must be 5121"},
        Fault{"SparseWithoutValues", "/accessors/0/sparse/values", nothing, "/accessors/0/sparse/values: missing"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G16, GltfFault,
    testing::Values(
        Fault{"NoSuchChild", "/nodes/0/children", json::array({1}), "/nodes/0/children/0: 1 is not one of the 1 nodes"},
        Fault{"OwnChild", "/nodes/0/children", json::array({0}), "/nodes/0: reached twice"},
        Fault{"NoSuchScene", "/scene", 1, "/scene: 1 is not one of the 1 scenes"},
        Fault{"NoSuchRoot", "/scenes/0/nodes/0", 2, "/scenes/0/nodes/0: 2 is not one of the 1 nodes"},
        Fault{"RootTwice", "/scenes/0/nodes", json::array({0, 0}), "/nodes/0: reached twice"},
        Fault{"TwoParents", "/nodes", json::array({{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}}),
              "/nodes/2: reached twice"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(G17, GltfFault,
                         testing::Values(Fault{"ShortMatrix", "/nodes/0/matrix", json::array({1, 2, 3}),
                                               "/nodes/0/matrix: must be a list of 16 numbers"},
                                         Fault{"TextInVector", "/nodes/0/scale", json::array({1, "2", 3}),
                                               "/nodes/0/scale: must be a list of 3 numbers"},
                                         Fault{"NullInMatrix", "/nodes/0/matrix",
                                               json::array({nullptr, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
                                               "/nodes/0/matrix: must be a list of 16 numbers"}),
                         name_of_fault);

INSTANTIATE_TEST_SUITE_P(G19, GltfFault,
                         testing::Values(Fault{"NoMode", "/meshes/0/primitives/0/mode", 7,
                                               "/meshes/0/primitives/0/mode: 7 is no primitive mode (0 to 6)"}),
                         name_of_fault);

INSTANTIATE_TEST_SUITE_P(G21, GltfFault,
                         testing::Values(Fault{"ImageTwice", "/images/0/bufferView", 0,
                                               "/images/0: must have either a uri or a bufferView"}),
                         name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    G23, GltfFault,
    testing::Values(Fault{"ShortColour", "/materials/0/pbrMetallicRoughness", json{{"baseColorFactor", {1, 1, 1}}},
                          "/materials/0/pbrMetallicRoughness/baseColorFactor: must be a list of 4 numbers"},
                    Fault{"NullRoughness", "/materials/0/pbrMetallicRoughness", json{{"roughnessFactor", nullptr}},
                          "/materials/0/pbrMetallicRoughness/roughnessFactor: must be a number"}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(G24, GltfFault,
                         testing::Values(Fault{"NoSuchCamera", "/nodes/0/camera", 1,
                                               "/nodes/0/camera: 1 is not one of the 1 cameras"}),
                         name_of_fault);

TEST(G01, FilesThatAreNoGltf) {
    const auto folder = scratch_folder();
    EXPECT_TRUE(holds(error_of([&] { (void)load_gltf(folder); }), "it is a directory"));
    EXPECT_TRUE(holds(error_of([&] { (void)load_gltf(folder / "none.gltf"); }), "it does not exist"));
    EXPECT_EQ(load_error(""), "scene.gltf: the file is empty");
    EXPECT_EQ(load_error("{}\n"), "scene.gltf: /asset: missing");
    EXPECT_EQ(load_error("abc"), "scene.gltf: line 1, column 1: not valid JSON, or the file is cut off");
    EXPECT_EQ(load_error("[1, 2]"), "scene.gltf: the JSON is not an object, so this is not glTF");
    EXPECT_EQ(load_error("{\n \"asset\": {,\n"),
              "scene.gltf: line 2, column 12: not valid JSON, or the file is cut off");
    EXPECT_TRUE(holds(load_error("{\"asset\": 1e309}"), "number that is too large"));
    EXPECT_TRUE(holds(load_error(std::string("\xff\xfe{\0\"\0", 6)), "not valid JSON")) << "UTF-16";
}

TEST(G02, AByteOrderMarkDoesNoHarm) { EXPECT_EQ(load_error("\xef\xbb\xbf" + one_triangle().text()), ""); }

TEST(G02, DeepNestingDoesNotExhaustTheStack) {
    const std::size_t depth = 1'000'000;
    const std::string deep =
        R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
    EXPECT_EQ(load_error(deep), "scene.gltf: JSON nested deeper than 256");
    const std::string brackets_in_text = R"({"asset":{"version":"2.0"},"extras":"\")" + std::string(1000, '[') + "\"}";
    EXPECT_EQ(load_error(brackets_in_text), "");
}

}  // namespace
}  // namespace kd
