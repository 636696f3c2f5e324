// Writing with libpng, which leaves a function by longjmp on failure. Therefore what needs destruction lives in Writer,
// outside of the function that calls setjmp.
#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <png.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

struct Writer {
    std::string bytes;
    bool out_of_memory = false;
    char reason[128] = "out of memory";
    std::vector<png_text> text;
    png_structp png = nullptr;
    png_infop info = nullptr;

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto* writer = static_cast<Writer*>(png_get_error_ptr(png));
    std::strncpy(writer->reason, message, sizeof(writer->reason) - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, png_size_t count) {
    auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
    try {
        writer->bytes.append(reinterpret_cast<const char*>(data), count);
    } catch (const std::exception&) {
        writer->out_of_memory = true;  // no exception may cross libpng; longjmp may not leave a handler
    }
    if (writer->out_of_memory) png_error(png, "out of memory");
}

void on_flush(png_structp) {}

/// False with Writer::reason on failure.
bool encode(Writer& writer, const Image<Rgba8>& image) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &writer, on_write, on_flush);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(writer.png, writer.info, writer.text.data(), static_cast<int>(writer.text.size()));
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < image.height; ++y) {
        const Rgba8* row = image.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
        png_write_row(writer.png, reinterpret_cast<png_const_bytep>(row));
    }
    png_write_end(writer.png, writer.info);
    return true;
}

bool plain_ascii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= 0x20 && c < 0x7f); });
}

/// libpng's view of `text`; the strings stay where they are.
std::vector<png_text> chunks_of(const PngText& text, const std::filesystem::path& path) {
    std::vector<png_text> chunks;
    for (const auto& [key, value] : text) {
        // libpng would drop such a keyword with no more than a warning.
        if (key.empty() || key.size() > 79 || !plain_ascii(key) || key.find('\n') != std::string::npos ||
            key.front() == ' ' || key.back() == ' ' || key.find("  ") != std::string::npos) {
            throw InputError("cannot write " + printable(path.string(), 4096) + ": '" + printable(key) +
                             "' is not a PNG keyword (1 to 79 ASCII characters)");
        }
        png_text chunk{};
        chunk.compression = plain_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<png_charp>(key.c_str());  // libpng copies both
        chunk.text = const_cast<png_charp>(value.c_str());
        chunk.text_length = value.size();
        chunks.push_back(chunk);
    }
    return chunks;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image<Rgba8>& image, const PngText& text) {
    const auto require = [&](bool good, const char* reason) {
        if (!good) throw InputError("cannot write " + printable(path.string(), 4096) + ": " + reason);
    };
    require(image.width > 0 && image.height > 0, "the picture is empty");
    Writer writer;
    writer.text = chunks_of(text, path);
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, on_error, on_warning);
    require(writer.png != nullptr, writer.reason);
    writer.info = png_create_info_struct(writer.png);
    require(writer.info != nullptr, writer.reason);
    require(encode(writer, image), writer.reason);
    write_file(path, writer.bytes);
}

}  // namespace kd
