// glTF files for several tests.
#pragma once

#include "renderer/io/png.h"
#include "tests/io/gltf_builder.h"

namespace kd {

/// A file with something of everything that is decoded: sparse data, indices, a texture, a light, a camera, a
/// hierarchy.
inline GltfBuilder rich_file() {
    GltfBuilder builder = one_triangle();
    auto& json = builder.json;
    json["meshes"][0]["primitives"][0]["indices"] = builder.add_indices({0, 1, 2, 2, 1, 0});
    json["meshes"][0]["primitives"][0]["material"] = 0;
    json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = builder.add_vec3({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    const std::vector<std::uint16_t> at{1};
    const std::vector<Vec3> to{{2, 0, 0}};
    json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", builder.add_view(at.data(), 2)}, {"componentType", 5123}}},
        {"values", {{"bufferView", builder.add_view(to.data(), 12)}}}};
    const auto path = scratch_folder() / "image.png";
    write_png(path, Image<Rgba8>(4, 4, {1, 2, 3, 4}));
    const std::string png = get_bytes(path);
    json["images"] = {{{"bufferView", builder.add_view(png.data(), png.size())}, {"mimeType", "image/png"}}};
    json["textures"] = {{{"source", 0}}};
    json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 0}}}}}}};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
    json["nodes"].push_back({{"children", {2}}, {"camera", 0}, {"rotation", {0, 0, 0, 1}}});
    json["nodes"].push_back({{"mesh", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    json["scenes"][0]["nodes"].push_back(1);
    return builder;
}

}  // namespace kd
