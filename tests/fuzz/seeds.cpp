#include "tests/fuzz/seeds.h"

#include "app/session_file.h"
#include "tests/io/gltf_samples.h"

namespace kd::fuzz {

namespace {

using nlohmann::json;

/// A square by a mode other than plain triangles, with indices.
GltfBuilder square(int mode) {
    GltfBuilder builder;
    json& primitive =
        builder.add_primitive({{"POSITION", builder.add_vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})}});
    primitive["mode"] = mode;
    primitive["indices"] = builder.add_indices({0, 1, 2, 3});
    return builder;
}

GltfBuilder interleaved() {
    const std::vector<Vec3> position_and_normal{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
    GltfBuilder builder;
    builder.add_view(position_and_normal.data(), position_and_normal.size() * sizeof(Vec3));
    builder.json["bufferViews"][0]["byteStride"] = 2 * sizeof(Vec3);
    for (const std::size_t offset : {std::size_t(0), sizeof(Vec3)}) {
        builder.json["accessors"].push_back(
            {{"bufferView", 0}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    }
    builder.add_primitive({{"POSITION", 0}, {"NORMAL", 1}});
    return builder;
}

GltfBuilder quantized() {
    const std::vector<std::int16_t> shorts{0, 0, 0, 0, -300, 0, 7, 0, 0, 40, 1, 0};
    GltfBuilder builder;
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    builder.add_accessor(shorts, "VEC3", 5122, 3);
    builder.json["bufferViews"][0]["byteStride"] = 8;
    builder.add_primitive({{"POSITION", 0}});
    return builder;
}

GltfBuilder skinned() {
    GltfBuilder builder = one_triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    builder.json["skins"] = {{{"joints", {0}}, {"skeleton", 0}}};
    builder.json["nodes"][0]["skin"] = 0;
    builder.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                   {"samplers", {{{"input", 1}, {"output", 0}, {"interpolation", "STEP"}}}}}};
    return builder;
}

/// A node, a morph target and a joint that move, each by another interpolation.
GltfBuilder animated() {
    GltfBuilder builder = one_triangle();
    json& gltf = builder.json;
    json& primitive = gltf["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", 0}}};
    primitive["attributes"]["JOINTS_0"] = builder.add_accessor(std::vector<std::uint8_t>(12, 0), "VEC4", 5121, 3);
    primitive["attributes"]["WEIGHTS_0"] = builder.add_accessor(std::vector<float>(12, 0.25f), "VEC4", 5126, 3);
    gltf["skins"] = {{{"joints", {1}}}};
    gltf["nodes"][0]["skin"] = 0;
    gltf["nodes"].push_back({{"translation", {0, 1, 0}}});
    gltf["scenes"][0]["nodes"].push_back(1);
    const std::size_t times = builder.add_accessor(std::vector<float>{0, 1}, "SCALAR", 5126, 2);
    const std::size_t weights = builder.add_accessor(std::vector<float>{0, 2}, "SCALAR", 5126, 2);
    const std::size_t turns = builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 1, 0, 0}, "VEC4", 5126, 2);
    const std::size_t ways = builder.add_accessor(std::vector<float>(18, 0.5f), "VEC3", 5126, 6);
    const auto channel = [](int sampler, int node, const char* path) {
        return json{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
    };
    gltf["animations"] = {
        {{"channels", {channel(0, 0, "weights"), channel(1, 1, "rotation"), channel(2, 1, "translation")}},
         {"samplers",
          {{{"input", times}, {"output", weights}, {"interpolation", "STEP"}},
           {{"input", times}, {"output", turns}},
           {{"input", times}, {"output", ways}, {"interpolation", "CUBICSPLINE"}}}}}};
    return builder;
}

/// A JPEG on a glossy material, moved, clamped, and with a picture of roughness.
GltfBuilder textured() {
    GltfBuilder builder = one_triangle();
    const std::string jpeg = get_bytes(std::string(KD_SOURCE_DIR) + "/tests/fixtures/io/two_colours.jpg");
    json& gltf = builder.json;
    gltf["images"] = {{{"bufferView", builder.add_view(jpeg.data(), jpeg.size())}, {"mimeType", "image/jpeg"}},
                      {{"uri", "missing.png"}}};
    gltf["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
    gltf["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
    const json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {2, 2}}, {"rotation", 1}}}};
    gltf["materials"] = {
        {{"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {1, 1, 1, 1}},
             {"specularFactor", {0.5, 0.5, 0.5}},
             {"glossinessFactor", 0.75},
             {"diffuseTexture", {{"index", 0}, {"extensions", transform}}}}}}}},
        {{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}, {"roughnessFactor", 0.5}}},
         {"alphaMode", "BLEND"},
         {"emissiveFactor", {0, 1, 0}}}};
    gltf["meshes"][0]["primitives"][0]["material"] = 0;
    builder.add_primitive({{"POSITION", 0}})["material"] = 1;
    return builder;
}

GltfBuilder placed() {
    GltfBuilder builder = one_triangle();
    json& nodes = builder.json["nodes"];
    nodes.push_back({{"matrix", {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}, {"children", {0, 2}}});
    nodes.push_back({{"mesh", 0}, {"rotation", {0, 0, 2, 2}}, {"scale", {2, 3, 4}}, {"translation", {0, 0, 1}}});
    builder.json["scenes"] = {{{"nodes", {1}}}};
    builder.json["scene"] = 0;
    return builder;
}

}  // namespace

Seeds gltf_seeds() {
    return {{"triangle.gltf", one_triangle().text()},
            {"triangle.glb", one_triangle().glb()},
            {"rich.gltf", rich_file().text()},
            {"rich.glb", rich_file().glb()},
            {"points.glb", square(0).glb()},
            {"strip.glb", square(5).glb()},
            {"fan.glb", square(6).glb()},
            {"interleaved.glb", interleaved().glb()},
            {"quantized.glb", quantized().glb()},
            {"skinned.glb", skinned().glb()},
            {"animated.glb", animated().glb()},
            {"textured.glb", textured().glb()},
            {"placed.glb", placed().glb()},
            {"empty.gltf", GltfBuilder().text()}};
}

Seeds rays_csv_seeds() {
    const std::string header = "ox,oy,oz,dx,dy,dz\n";
    return {{"header.csv", header},
            {"decimal.csv", header + "1,2,3,0,0,-1\n-0.5,1e-3,+2.5E2,0,1,0\n"},
            {"hexadecimal.csv", "ox,oy,oz,dx,dy,dz,tmin,tmax\n0x1.8p+1,-0X1p-149,0,0,0,-0x1p+0,0x0p+0,0x1p+60\n"},
            {"special.csv", "tmax,dz,dy,dx,oz,oy,ox\ninf,nan,-inf,1e-60,16777217,-0,1e-45\n"},
            {"spreadsheet.csv", "\xef\xbb\xbf ox ,oy,oz,dx,dy,dz\r\n\r\n1 ,2,3, 4,5,6\r\n"}};
}

Seeds session_seeds() {
    const auto text = [](const Session& session) { return session_text("seed.session.json", session); };
    Session placed;
    placed.scene = "models/engine.glb";
    placed.time = -1.5;
    placed.camera = Camera{Vec3(1, -2, 0.1f), Vec3(0), Vec3(0, 0, 1), 45.5f};
    Session tuned;
    tuned.build.builder = "exact";
    tuned.build.empty_bonus = 0.3f;
    tuned.trace.traversal = Traversal::short_stack;
    tuned.trace.rules = Rules::first_edition;
    tuned.trace.nodes = NodeEncoding::packed;
    tuned.trace.forced = FeatureSet(Feature::ropes).with(Feature::normals);
    Session seen;
    seen.view.show_map = true;
    seen.view.map.map = "nodes";
    seen.view.heat.logarithmic = true;
    seen.view.heat.range_mode = RangeMode::fixed;
    seen.view.heat.range_min = 1;
    seen.view.heat.range_max = 1e6f;
    seen.view.overlay.show = true;
    seen.tracer = TracerKind::gl_fragment;
    return {{"default.session.json", text({})},
            {"placed.session.json", text(placed)},
            {"tuned.session.json", text(tuned)},
            {"seen.session.json", text(seen)},
            {"least.session.json", "{\"kdscope_session\": 1}"},
            {"newer.session.json", "{\"kdscope_session\": 2, \"settings\": {}}"}};
}

}  // namespace kd::fuzz
