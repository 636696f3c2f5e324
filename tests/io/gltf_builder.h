// Small glTF files made in memory for tests: a JSON document that a test may change, and one buffer.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "renderer/geometry/shared_types.h"
#include "renderer/io/gltf.h"
#include "tests/io/scratch.h"

namespace kd {

inline std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

struct GltfBuilder {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::string bytes;

    /// A bufferView that holds these bytes; returns its number.
    std::size_t add_view(const void* data, std::size_t size) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
        bytes.append(static_cast<const char*>(data), size);
        return json["bufferViews"].size() - 1;
    }

    template <class T>
    std::size_t add_accessor(const std::vector<T>& values, const char* type, int component_type, std::size_t count) {
        const std::size_t view = add_view(values.data(), values.size() * sizeof(T));
        json["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
        return json["accessors"].size() - 1;
    }
    std::size_t add_vec3(const std::vector<Vec3>& v) { return add_accessor(v, "VEC3", 5126, v.size()); }
    std::size_t add_vec2(const std::vector<Vec2>& v) { return add_accessor(v, "VEC2", 5126, v.size()); }
    std::size_t add_indices(const std::vector<std::uint16_t>& v) { return add_accessor(v, "SCALAR", 5123, v.size()); }

    /// A mesh of one primitive, a node that shows it, and the scene that lists the node.
    nlohmann::json& add_primitive(nlohmann::json attributes) {
        json["meshes"].push_back({{"primitives", {{{"attributes", std::move(attributes)}}}}});
        json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        return json["meshes"].back()["primitives"][0];
    }

    [[nodiscard]] std::string text() const {
        nlohmann::json whole = json;
        if (!bytes.empty() && !whole.contains("buffers")) {
            whole["buffers"] = {
                {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        }
        return whole.dump();
    }

    [[nodiscard]] std::string glb() const {
        nlohmann::json whole = json;
        if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string document = whole.dump();
        std::string data = bytes;
        document.resize((document.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4, '\0');
        std::string file = "glTF" + word(2) + word(12 + 8 + document.size() + 8 + data.size());
        file += word(document.size()) + "JSON" + document;
        return file + word(data.size()) + std::string("BIN\0", 4) + data;
    }

    /// Little-endian, as in the header of a GLB.
    static std::string word(std::size_t value) {
        std::string four;
        for (int i = 0; i < 4; ++i) four += static_cast<char>(value >> (8 * i) & 0xff);
        return four;
    }
};

/// One triangle, with texture coordinates.
inline GltfBuilder one_triangle() {
    GltfBuilder builder;
    const std::size_t positions = builder.add_vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const std::size_t uvs = builder.add_vec2({{0, 0}, {1, 0}, {0, 1}});
    builder.add_primitive({{"POSITION", positions}, {"TEXCOORD_0", uvs}});
    return builder;
}

/// Loads `text` from a file in the test's own, emptied folder.
inline Scene load_text(const std::string& text, const char* name = "scene.gltf") {
    const auto path = scratch_folder() / name;
    put_bytes(path, text);
    return load_gltf(path);
}

inline Scene load(const GltfBuilder& builder) { return load_text(builder.text()); }

/// The error that loading ends in, from the file's name on; "" where it does not.
inline std::string load_error(const std::string& text, const char* name = "scene.gltf") {
    const std::string error = error_of([&] { (void)load_text(text, name); });
    const std::size_t begin = error.find(name);
    return begin == std::string::npos ? error : error.substr(begin);
}

inline bool has_note(const Scene& scene, const std::string& part) {
    for (const std::string& note : scene.notes) {
        if (note.find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace kd
