// What a glTF file refers to: its buffers and images. The only files that the loader opens beside the scene itself.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "renderer/io/gltf_container.h"
#include "renderer/io/gltf_context.h"

namespace kd {

class GltfResources {
  public:
    /// Checks every buffer, bufferView and image of `gltf`, whose single values are right already, and reads the files
    /// that hold buffers. InputError where a URI must not be opened, a buffer is not there or too short, a bufferView
    /// reaches beyond its buffer, or all together is larger than the limits. Images are not opened yet.
    GltfResources(GltfContext& context, const nlohmann::json& gltf, const GltfText& text, std::filesystem::path folder);

    /// True for the names that tinygltf gives to what the scene refers to: its decoded URIs.
    [[nodiscard]] bool knows(const std::string& name) const { return files_.contains(name); }
    /// The file of that name. InputError where it cannot be read or is an image above the limit. tinygltf asks once for
    /// each buffer, in their order, and then for the images: each buffer gets as many bytes as its byteLength says,
    /// also where several are parts of one file.
    [[nodiscard]] std::vector<unsigned char> read(const std::string& name);

  private:
    struct File {
        std::filesystem::path path;
        std::string bytes;                  // of buffers
        std::deque<std::uint64_t> lengths;  // of the buffers in it that were not read yet
    };
    void add_buffer(const GltfContext& context, const nlohmann::json& buffer, std::size_t index, const GltfText& text);
    /// Bytes of the image, encoded.
    std::uint64_t add_image(const GltfContext& context, const nlohmann::json& image, const nlohmann::json& views,
                            const std::string& pointer);
    File& add_file(const GltfContext& context, const std::string& uri, const std::string& pointer);

    std::filesystem::path folder_;
    GltfLimits limits_;
    std::map<std::string, File> files_;
};

}  // namespace kd
