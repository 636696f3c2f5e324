#include "renderer/io/gltf_parse.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "renderer/geometry/input_error.h"
#include "renderer/io/gltf_json.h"
#include "renderer/io/gltf_resources.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

// What tinygltf calls in place of its own file access and image decoders. `user` is the GltfResources.

bool file_exists(const std::string& name, void* user) { return static_cast<const GltfResources*>(user)->knows(name); }

std::string same_path(const std::string& name, void*) { return name; }

bool read_whole_file(std::vector<unsigned char>* out, std::string* error, const std::string& name, void* user) {
    try {
        *out = static_cast<GltfResources*>(user)->read(name);
        return true;
    } catch (const InputError& reason) {
        *error = reason.what();
        return false;
    }
}

/// Keeps an image as it is stored; most are never shown, so decoding waits until one is.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
    image->image.assign(bytes, bytes + std::max(size, 0));
    image->as_is = true;
    return true;
}

std::string first_line(const std::string& text) { return printable(text.substr(0, text.find('\n')), 200); }

tinygltf::Model decode(const GltfContext& context, const GltfText& text, GltfResources& resources) {
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({file_exists, same_path, read_whole_file, nullptr, &resources});
    loader.SetImageLoader(keep_encoded, nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;          // about images that are missing, which are noted where they are used
    const std::string no_folder;  // every name is looked up in `resources`
    bool good = false;
    if (text.is_binary()) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(text.container.data());
        const auto size = static_cast<unsigned>(text.container.size());
        good = loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, size, no_folder);
    } else {
        const auto size = static_cast<unsigned>(text.json.size());
        good = loader.LoadASCIIFromString(&model, &error, &warning, text.json.data(), size, no_folder);
    }
    if (!good) context.fail("", error.empty() ? "not a glTF file that can be decoded" : first_line(error));
    return model;
}

}  // namespace

tinygltf::Model parse_gltf(GltfContext& context, std::string_view bytes, const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const GltfText text = open_gltf(context, bytes, extension == ".glb");
    const nlohmann::json json = parse_gltf_json(context, text.json);
    check_gltf_json(context, json);
    GltfResources resources(context, json, text, path.parent_path());
    return decode(context, text, resources);
}

}  // namespace kd
