#include "renderer/io/gltf_container.h"

#include <cstdint>
#include <string>

namespace kd {

namespace {

constexpr std::uint64_t header_size = 12;
constexpr std::uint64_t chunk_header_size = 8;
constexpr std::uint32_t json_type = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t binary_type = 0x004e4942;  // "BIN"

/// Little-endian, as GLB is on every machine.
std::uint32_t word_at(std::string_view bytes, std::uint64_t offset) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i) {
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
    }
    return word;
}

/// glTF as text, whatever its name says: an object, perhaps after a byte order mark.
bool begins_like_json(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{';
}

/// The chunk at `offset`; its header and all its bytes lie within `container`.
std::string_view chunk_at(const GltfContext& context, std::string_view container, std::uint64_t offset,
                          std::uint32_t type, const char* name) {
    const auto require = [&](bool good, const char* reason) {
        if (!good) context.fail("", std::string("GLB ") + name + " chunk: " + reason);
    };
    require(offset + chunk_header_size <= container.size(), "missing; the file is cut off");
    const std::uint64_t length = word_at(container, offset);
    require(word_at(container, offset + 4) == type, "another kind of chunk stands in its place");
    require(length <= container.size() - offset - chunk_header_size, "longer than the file");
    require(length % 4 == 0, "its length must be a multiple of 4");
    require(length > 0, "empty");
    return container.substr(offset + chunk_header_size, length);
}

}  // namespace

GltfText open_gltf(GltfContext& context, std::string_view bytes, bool named_glb) {
    if (bytes.empty()) context.fail("", "the file is empty");
    if (!bytes.starts_with("glTF")) {
        if (named_glb && !begins_like_json(bytes)) {
            context.fail("",
                         "GLB header: bad magic '" + std::string(bytes.substr(0, 4)) + "'; a GLB begins with 'glTF'");
        }
        return {.json = bytes, .container = {}};
    }
    if (bytes.size() < header_size) context.fail("", "GLB header: cut off");
    if (const std::uint32_t version = word_at(bytes, 4); version != 2) {
        context.fail("", "GLB version " + std::to_string(version) + " is not supported; export as glTF 2.0");
    }
    const std::uint64_t length = word_at(bytes, 8);
    if (length < header_size || length > bytes.size()) {
        context.fail("", "GLB header: says " + std::to_string(length) + " bytes, the file has " +
                             std::to_string(bytes.size()));
    }
    if (length < bytes.size()) context.note("ignored bytes after the end of the GLB");

    const std::string_view container = bytes.substr(0, length);
    const std::string_view json = chunk_at(context, container, header_size, json_type, "JSON");
    GltfText text{.json = json, .container = container};
    const std::uint64_t next = header_size + chunk_header_size + json.size();
    if (next < length) text.binary_size = chunk_at(context, container, next, binary_type, "BIN").size();
    return text;
}

}  // namespace kd
