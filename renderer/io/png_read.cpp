// Reading with libpng, which leaves a function by longjmp when a file is broken. Therefore what needs destruction lives
// in Reader, outside of the functions that call setjmp.
#include <csetjmp>
#include <cstring>
#include <png.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr std::uint64_t largest_pixel_count = std::uint64_t(1) << 28;  // 1 GiB of RGBA

struct Reader {
    std::string_view rest;  // bytes that libpng has not asked for yet
    char reason[128] = "";  // why reading stopped
    png_structp png = nullptr;
    png_infop info = nullptr;
    Image<Rgba8> image;
    PngText text;

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto* reader = static_cast<Reader*>(png_get_error_ptr(png));
    std::strncpy(reader->reason, message, sizeof(reader->reason) - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep out, png_size_t count) {
    auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
    if (count > reader->rest.size()) png_error(png, "it ends too early");
    std::memcpy(out, reader->rest.data(), count);
    reader->rest.remove_prefix(count);
}

/// Reads the header and asks for RGBA rows. False with Reader::reason on failure.
bool read_header(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &reader, on_read);
    png_read_info(reader.png, reader.info);
    const std::uint64_t width = png_get_image_width(reader.png, reader.info);
    const std::uint64_t height = png_get_image_height(reader.png, reader.info);
    if (width * height > largest_pixel_count) png_error(reader.png, "it has more than 2^28 pixels");

    png_set_expand(reader.png);  // palettes, 1 to 4 bits, transparent colours
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
    return true;
}

/// Reads all rows into Reader::image, which has its size already, and the chunks after them.
bool read_rows(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    const auto width = static_cast<std::size_t>(reader.image.width);
    if (png_get_rowbytes(reader.png, reader.info) != width * sizeof(Rgba8))
        png_error(reader.png, "unexpected row size");
    for (int pass = 0; pass < passes; ++pass) {
        for (int y = 0; y < reader.image.height; ++y) {
            Rgba8* row = reader.image.pixels.data() + static_cast<std::size_t>(y) * width;
            png_read_row(reader.png, reinterpret_cast<png_bytep>(row), nullptr);
        }
    }
    png_read_end(reader.png, reader.info);
    return true;
}

void collect_text(Reader& reader) {
    png_textp entries = nullptr;
    const int count = png_get_text(reader.png, reader.info, &entries, nullptr);
    for (int i = 0; i < count; ++i) {
        const png_text& entry = entries[i];
        const std::size_t length = entry.compression > 0 ? entry.itxt_length : entry.text_length;
        if (entry.text != nullptr) reader.text[entry.key] = std::string(entry.text, length);
    }
}

void read_all(Reader& reader, std::string_view bytes, const std::string& name) {
    static_assert(sizeof(Rgba8) == 4);
    const auto require = [&](bool good) {
        if (!good) throw InputError(printable(name, 4096) + ": not a readable PNG: " + printable(reader.reason));
    };
    reader.rest = bytes;
    std::strcpy(reader.reason, "out of memory");
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
    require(reader.png != nullptr);
    reader.info = png_create_info_struct(reader.png);
    require(reader.info != nullptr);
    require(read_header(reader));
    reader.image = Image<Rgba8>(static_cast<int>(png_get_image_width(reader.png, reader.info)),
                                static_cast<int>(png_get_image_height(reader.png, reader.info)));
    require(read_rows(reader));
    collect_text(reader);
}

}  // namespace

Image<Rgba8> decode_png(std::string_view bytes, const std::string& name) {
    Reader reader;
    read_all(reader, bytes, name);
    return std::move(reader.image);
}

Image<Rgba8> read_png(const std::filesystem::path& path) { return decode_png(read_file(path), path.string()); }

PngText read_png_text(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    Reader reader;
    read_all(reader, bytes, path.string());
    return std::move(reader.text);
}

}  // namespace kd
