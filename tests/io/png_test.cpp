#include "renderer/io/png.h"

#include <cstdio>
#include <memory>
#include <png.h>

#include "tests/io/scratch.h"

namespace kd {
namespace {

Image<Rgba8> pattern(int width, int height) {
    Image<Rgba8> image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = {static_cast<unsigned char>(7 * x + y), static_cast<unsigned char>(x ^ y),
                              static_cast<unsigned char>(y * 5), static_cast<unsigned char>(255 - 3 * x)};
        }
    }
    return image;
}

struct Format {
    int depth, colour, interlace;
};

/// A PNG of any format straight from libpng; `rows` as that format stores them.
void write_raw(const std::filesystem::path& path, int width, int height, Format format,
               std::vector<std::vector<unsigned char>> rows, const std::vector<png_color>& palette = {},
               std::vector<unsigned char> alpha = {}) {
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file.get());
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), format.depth,
                 format.colour, format.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_gAMA(png, info, 1.0);  // must not change what is read
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    if (!alpha.empty()) png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()), nullptr);
    std::vector<png_bytep> pointers;
    for (auto& row : rows) pointers.push_back(row.data());
    png_set_rows(png, info, pointers.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
}

TEST(Png, RoundTripsEveryPixel) {
    const auto path = scratch_folder() / "a.png";
    const Image<Rgba8> image = pattern(37, 23);
    write_png(path, image);
    EXPECT_EQ(read_png(path), image);
    EXPECT_EQ(count_files(path.parent_path()), 1);
}

TEST(Png, KeepsText) {
    const auto path = scratch_folder() / "a.png";
    const PngText text{{"kdscope", "{\"scene\":\"ball:9000\"}"},
                       {"Title", "Gr\xc3\xbc\xc3\x9f"
                                 "e, \xe2\x88\x9e"},
                       {"Empty", ""},
                       {"Long", std::string(100'000, 'x')}};
    write_png(path, pattern(3, 3), text);
    EXPECT_EQ(read_png_text(path), text);
    EXPECT_EQ(read_png(path), pattern(3, 3));
    EXPECT_TRUE(holds(get_bytes(path), "tEXtkdscope"));
    EXPECT_TRUE(holds(get_bytes(path), "iTXtTitle"));
}

TEST(Png, RefusesBadKeywordsAndEmptyPictures) {
    const auto folder = scratch_folder();
    for (const std::string& key : {std::string(), std::string(80, 'k'), std::string("a\nb"), std::string(" a")}) {
        EXPECT_TRUE(holds(error_of([&] { write_png(folder / "a.png", pattern(1, 1), {{key, "x"}}); }), "keyword"));
    }
    EXPECT_TRUE(holds(error_of([&] { write_png(folder / "a.png", {}); }), "the picture is empty"));
    EXPECT_EQ(count_files(folder), 0);
}

TEST(Png, WritingNamesPathAndReason) {
    const auto folder = scratch_folder();
    EXPECT_TRUE(
        holds(error_of([&] { write_png(folder / "no" / "a.png", pattern(1, 1)); }), "a.png: there is no folder"));
}

TEST(Png, ReadsRgbAndGreyWithoutAlphaAsOpaque) {
    const auto folder = scratch_folder();
    write_raw(folder / "rgb.png", 2, 1, {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE}, {{1, 2, 3, 250, 251, 252}});
    Image<Rgba8> expected(2, 1);
    expected.pixels = {{1, 2, 3, 255}, {250, 251, 252, 255}};
    EXPECT_EQ(read_png(folder / "rgb.png"), expected);

    write_raw(folder / "grey.png", 2, 1, {8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE}, {{9, 200}});
    expected.pixels = {{9, 9, 9, 255}, {200, 200, 200, 255}};
    EXPECT_EQ(read_png(folder / "grey.png"), expected);

    write_raw(folder / "bit.png", 2, 1, {1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE}, {{0x40}});
    expected.pixels = {{0, 0, 0, 255}, {255, 255, 255, 255}};
    EXPECT_EQ(read_png(folder / "bit.png"), expected);
}

TEST(Png, ReadsPalettesWithTransparency) {
    const auto path = scratch_folder() / "palette.png";
    write_raw(path, 3, 1, {8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE}, {{2, 0, 1}},
              {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}}, {128});
    Image<Rgba8> expected(3, 1);
    expected.pixels = {{70, 80, 90, 255}, {10, 20, 30, 128}, {40, 50, 60, 255}};
    EXPECT_EQ(read_png(path), expected);
}

TEST(Png, ScalesSixteenBitsToEight) {
    const auto path = scratch_folder() / "deep.png";
    // 0x0000, 0x80ff, 0xffff, alpha 0x7fff: v * 255 / 65535, rounded
    write_raw(path, 1, 1, {16, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE},
              {{0x00, 0x00, 0x80, 0xff, 0xff, 0xff, 0x7f, 0xff}});
    EXPECT_EQ(read_png(path).at(0, 0), (Rgba8{0, 128, 255, 127}));
}

TEST(Png, ReadsInterlacedPictures) {
    const auto path = scratch_folder() / "adam7.png";
    const Image<Rgba8> image = pattern(13, 11);
    std::vector<std::vector<unsigned char>> rows;
    for (int y = 0; y < 11; ++y) {
        rows.emplace_back();
        for (int x = 0; x < 13; ++x) {
            const Rgba8 p = image.at(x, y);
            rows.back().insert(rows.back().end(), {p.r, p.g, p.b, p.a});
        }
    }
    write_raw(path, 13, 11, {8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_ADAM7}, rows);
    EXPECT_EQ(read_png(path), image);
}

TEST(Png, BrokenFilesAreInputErrors) {
    const auto folder = scratch_folder();
    write_png(folder / "whole.png", pattern(40, 30), {{"Key", "value"}});
    const std::string whole = get_bytes(folder / "whole.png");
    for (std::size_t length = 0; length < whole.size(); length += 13) {
        const std::string error = error_of([&] { (void)decode_png(whole.substr(0, length), "cut.png"); });
        EXPECT_TRUE(holds(error, "cut.png: not a readable PNG")) << length << " bytes";
    }
    std::string wrong_sum = whole;
    wrong_sum[20] = static_cast<char>(wrong_sum[20] ^ 1);  // in the header, which its checksum covers
    EXPECT_TRUE(holds(error_of([&] { (void)decode_png(wrong_sum, "sum.png"); }), "CRC"));
    EXPECT_TRUE(holds(error_of([&] { (void)read_png(folder / "none.png"); }), "it does not exist"));
    put_bytes(folder / "text.png", "this is no picture");
    EXPECT_TRUE(holds(error_of([&] { (void)read_png(folder / "text.png"); }), "text.png: not a readable PNG"));
}

TEST(Png, RefusesPicturesThatWouldFillTheMemory) {
    const auto path = scratch_folder() / "bomb.png";
    // A header that promises 60000 x 60000 pixels, with the checksum it needs, and nothing after it.
    const std::string header("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xea\x60\0\0\xea\x60\x08\x06\0\0\0\x80\xd2\x75\x42", 33);
    const std::string file = header + std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
    const std::string error = error_of([&] { (void)decode_png(file, "bomb.png"); });
    EXPECT_EQ(error, "bomb.png: not a readable PNG: it has more than 2^28 pixels");
}

}  // namespace
}  // namespace kd
