#include "renderer/io/gltf_resources.h"

#include <nlohmann/json.hpp>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/gltf_uri.h"
#include "renderer/io/printable.h"

namespace kd {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A URI in quotes, cut to what fits an error.
std::string shown(std::string_view uri) { return "'" + printable(uri, 80) + "' "; }

void check_view(const GltfContext& context, const json& view, const std::string& pointer, std::uint64_t buffer_length) {
    const auto offset = view.value("byteOffset", std::uint64_t(0));
    const auto length = view.at("byteLength").get<std::uint64_t>();
    if (length == 0) context.fail(pointer_to(pointer, "byteLength"), "must be 1 or more");
    if (offset > buffer_length || length > buffer_length - offset) {
        context.fail(pointer_to(pointer, "byteLength"), std::to_string(length) + " bytes from " +
                                                            std::to_string(offset) + " on reach beyond the buffer's " +
                                                            std::to_string(buffer_length));
    }
    const auto stride = view.find("byteStride");
    if (stride == view.end()) return;
    const auto bytes = stride->get<std::uint64_t>();
    if (bytes < 4 || bytes > 252 || bytes % 4 != 0) {
        context.fail(pointer_to(pointer, "byteStride"), "must be a multiple of 4 from 4 to 252");
    }
}

/// Adds `size` to `total`, neither above `limit`.
void add_within(const GltfContext& context, const std::string& pointer, const char* what, std::uint64_t size,
                std::uint64_t limit, std::uint64_t& total) {
    if (size > limit - total) {
        context.fail(pointer,
                     std::string("the ") + what + " are larger than the limit of " + std::to_string(limit) + " bytes");
    }
    total += size;
}

}  // namespace

GltfResources::GltfResources(GltfContext& context, const json& gltf, const GltfText& text, std::filesystem::path folder)
    : folder_(folder.empty() ? "." : std::move(folder)), limits_(context.limits()) {
    const json none = json::array();
    const auto list = [&](const char* name) -> const json& { return gltf.contains(name) ? gltf.at(name) : none; };

    // Sizes first, all together, before anything is allocated or read.
    const json& buffers = list("buffers");
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string pointer = pointer_to(pointer_to("/buffers", i), "byteLength");
        const auto length = buffers[i].at("byteLength").get<std::uint64_t>();
        if (length == 0) context.fail(pointer, "must be 1 or more");
        add_within(context, pointer, "buffers", length, limits_.buffer_bytes, total);
    }
    for (std::size_t i = 0; i < buffers.size(); ++i) add_buffer(context, buffers[i], i, text);

    const json& views = list("bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto buffer = views[i].at("buffer").get<std::size_t>();
        check_view(context, views[i], pointer_to("/bufferViews", i), buffers[buffer].at("byteLength"));
    }
    const json& images = list("images");
    std::uint64_t encoded = 0;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string pointer = pointer_to("/images", i);
        add_within(context, pointer, "images", add_image(context, images[i], views, pointer), limits_.image_bytes,
                   encoded);
    }
}

void GltfResources::add_buffer(const GltfContext& context, const json& buffer, std::size_t index,
                               const GltfText& text) {
    const std::string pointer = pointer_to("/buffers", index);
    const auto length = buffer.at("byteLength").get<std::uint64_t>();
    const auto require_length = [&](std::uint64_t available, bool good) {
        if (good) return;
        context.fail(pointer_to(pointer, "byteLength"),
                     "says " + std::to_string(length) + " bytes, there are " + std::to_string(available));
    };
    const std::string uri = buffer.value("uri", "");
    if (uri.empty()) {
        if (!text.is_binary() || index > 0) context.fail(pointer_to(pointer, "uri"), "missing");
        require_length(text.binary_size, length <= text.binary_size);
    } else if (is_data_uri(uri)) {
        const std::optional<std::uint64_t> size = data_uri_size(uri);
        if (!size) {
            context.fail(pointer_to(pointer, "uri"),
                         shown(uri) + "cannot be decoded; use data:application/octet-stream;base64,...");
        }
        require_length(*size, length == *size);
    } else {
        File& file = add_file(context, uri, pointer_to(pointer, "uri"));
        try {
            if (file.bytes.empty()) file.bytes = read_file(file.path, limits_.buffer_bytes);
        } catch (const InputError& error) {
            context.fail(pointer_to(pointer, "uri"), error.what());
        }
        require_length(file.bytes.size(), length <= file.bytes.size());
        file.lengths.push_back(length);
    }
}

std::uint64_t GltfResources::add_image(const GltfContext& context, const json& image, const json& views,
                                       const std::string& pointer) {
    if (image.contains("uri") == image.contains("bufferView")) {
        context.fail(pointer, "must have either a uri or a bufferView");
    }
    if (!image.contains("uri")) {
        return views[image.at("bufferView").get<std::size_t>()].at("byteLength").get<std::uint64_t>();
    }
    const auto uri = image.at("uri").get<std::string>();
    if (is_data_uri(uri)) {
        const std::optional<std::uint64_t> size = data_uri_size(uri);
        if (size == std::uint64_t(0)) context.fail(pointer_to(pointer, "uri"), shown(uri) + "holds no data");
        return size.value_or(0);  // of another kind; tinygltf refuses it
    }
    std::error_code missing;  // told where the image is used
    const std::uintmax_t size = fs::file_size(add_file(context, uri, pointer_to(pointer, "uri")).path, missing);
    return missing || size > limits_.image_file_bytes ? 0 : size;
}

GltfResources::File& GltfResources::add_file(const GltfContext& context, const std::string& uri,
                                             const std::string& pointer) {
    const std::string decoded = decode_uri(uri);
    if (const auto objection = uri_objection(folder_, decoded)) context.fail(pointer, shown(uri) + *objection);
    // tinygltf asks for the name as it decodes it; what is opened is the name as it should be decoded.
    File& file = files_[decode_uri(uri, true)];
    file.path = folder_ / decoded;
    return file;
}

std::vector<unsigned char> GltfResources::read(const std::string& name) {
    File& file = files_.at(name);
    if (file.lengths.empty()) {
        const std::string bytes = read_file(file.path, limits_.image_file_bytes);
        return {bytes.begin(), bytes.end()};
    }
    const auto length = static_cast<std::ptrdiff_t>(file.lengths.front());
    file.lengths.pop_front();
    return {file.bytes.begin(), file.bytes.begin() + length};
}

}  // namespace kd
