#include "renderer/io/gltf_image.h"

#include <cstring>
#include <optional>
#include <span>

#include "renderer/geometry/input_error.h"
#include "renderer/io/png.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

using Bytes = std::span<const unsigned char>;

struct Size {
    std::uint64_t width, height;
};

std::uint64_t big_endian(Bytes bytes, std::size_t offset, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[offset + i];
    return value;
}

bool begins_with(Bytes bytes, std::string_view signature) {
    return bytes.size() >= signature.size() && std::memcmp(bytes.data(), signature.data(), signature.size()) == 0;
}

bool is_png(Bytes bytes) { return begins_with(bytes, "\x89PNG\r\n\x1a\n"); }
bool is_jpeg(Bytes bytes) { return begins_with(bytes, "\xff\xd8\xff"); }

/// From the IHDR chunk, which comes first.
std::optional<Size> png_size(Bytes bytes) {
    if (bytes.size() < 24) return std::nullopt;
    return Size{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
}

/// From the first frame header (ITU T.81, section B.2.2): marker C0..CF but for C4, C8 and CC, which mean other things.
std::optional<Size> jpeg_size(Bytes bytes) {
    std::size_t at = 2;
    while (at + 9 <= bytes.size()) {
        if (bytes[at] != 0xff) return std::nullopt;
        const unsigned marker = bytes[at + 1];
        if (marker == 0xff) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) return Size{big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
        at += 2 + big_endian(bytes, at + 2, 2);
    }
    return std::nullopt;
}

/// By the decoder that tinygltf brings. `bytes` begin as a JPEG does, and its size has been checked.
std::optional<Image<Rgba8>> decode_jpeg(Bytes bytes) {
    tinygltf::Image decoded;
    std::string ignored;
    if (!tinygltf::LoadImageData(&decoded, 0, &ignored, &ignored, 0, 0, bytes.data(), static_cast<int>(bytes.size()),
                                 nullptr)) {
        return std::nullopt;
    }
    Image<Rgba8> image(decoded.width, decoded.height);
    if (decoded.bits != 8 || decoded.component != 4 || decoded.image.size() != image.pixels.size() * sizeof(Rgba8)) {
        return std::nullopt;
    }
    std::memcpy(image.pixels.data(), decoded.image.data(), decoded.image.size());
    return image;
}

/// Nothing, with the reason in `reason`, where it cannot be decoded.
std::optional<Image<Rgba8>> decode(Bytes bytes, std::uint64_t most_pixels, std::string& reason) {
    reason = bytes.empty() ? "cannot be read" : "is neither PNG nor JPEG";
    if (!is_png(bytes) && !is_jpeg(bytes)) return std::nullopt;
    reason = "is broken";
    const std::optional<Size> size = is_png(bytes) ? png_size(bytes) : jpeg_size(bytes);
    if (!size || size->width == 0 || size->height == 0) return std::nullopt;
    // Both sides have at most 32 bits, so the product fits.
    if (size->width * size->height > most_pixels) {
        reason = "is too large with " + std::to_string(size->width) + " x " + std::to_string(size->height) + " pixels";
        return std::nullopt;
    }
    if (is_jpeg(bytes)) return decode_jpeg(bytes);
    try {
        return decode_png({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "image");
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::string name_of(const tinygltf::Image& image, std::size_t index) {
    const std::string& name = image.uri.empty() ? image.name : image.uri;
    return "image " + std::to_string(index) + (name.empty() ? "" : " (" + printable(name, 60) + ")");
}

}  // namespace

Image<Rgba8> decode_gltf_image(GltfContext& context, const tinygltf::Model& model, std::size_t index,
                               std::uint64_t& pixels_left) {
    const tinygltf::Image& image = model.images[index];
    std::string reason;
    std::optional<Image<Rgba8>> decoded =
        decode(image.image, std::min(context.limits().image_pixels, pixels_left), reason);
    if (!decoded) {
        context.note("replaced " + name_of(image, index) + " by white, as it " + reason);
        return Image<Rgba8>(1, 1, Rgba8{255, 255, 255, 255});
    }
    pixels_left -= decoded->pixels.size();
    return std::move(*decoded);
}

Vec3 mean_colour(const Image<Rgba8>& image) {
    std::uint64_t red = 0, green = 0, blue = 0;
    for (const Rgba8& pixel : image.pixels) {
        red += pixel.r;
        green += pixel.g;
        blue += pixel.b;
    }
    const double scale = 1.0 / (255.0 * static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1)));
    return Vec3(static_cast<double>(red) * scale, static_cast<double>(green) * scale,
                static_cast<double>(blue) * scale);
}

}  // namespace kd
