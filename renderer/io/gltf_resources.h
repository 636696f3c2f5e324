// What a glTF file refers to: its buffers and images. The only files that the loader opens beside the scene itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "renderer/io/gltf_container.h"
#include "renderer/io/gltf_context.h"

namespace kd {

inline constexpr std::uint64_t largest_buffer_total = std::uint64_t(2) << 30;  // bytes, all buffers of a file together
inline constexpr std::uint64_t largest_image_file = std::uint64_t(256) << 20;  // bytes, encoded

class GltfResources {
  public:
    /// Checks every buffer, bufferView and image of `gltf`, whose single values are right already, and reads the files
    /// that hold buffers. InputError where a URI must not be opened, a buffer is not there or too short, or a
    /// bufferView reaches beyond its buffer. Images are not opened yet.
    GltfResources(GltfContext& context, const nlohmann::json& gltf, const GltfText& text, std::filesystem::path folder);

    /// True for the names that tinygltf gives to what the scene refers to: its decoded URIs.
    [[nodiscard]] bool knows(const std::string& name) const { return files_.contains(name); }
    /// The file of that name. InputError where it cannot be read, or is larger than largest_image_file.
    [[nodiscard]] std::vector<unsigned char> read(const std::string& name) const;

  private:
    struct File {
        std::filesystem::path path;
        bool is_buffer = false;
        std::string bytes;  // of a buffer: as many as byteLength says
    };
    void add_buffer(const GltfContext& context, const nlohmann::json& buffer, std::size_t index, const GltfText& text);
    void add_image(const GltfContext& context, const nlohmann::json& image, std::size_t index);
    File& add_file(const GltfContext& context, const std::string& uri, const std::string& pointer);

    std::filesystem::path folder_;
    std::map<std::string, File> files_;
};

}  // namespace kd
