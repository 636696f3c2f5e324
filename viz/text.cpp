#include "viz/text.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "renderer/geometry/input_error.h"
#include "viz/colormap.h"
#include "viz/dot_glyphs.h"

// Private copies of its functions, so that no other copy in the program can take their place.
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace kd {

struct Font::Face {
    std::vector<unsigned char> bytes;  // `info` points into them
    stbtt_fontinfo info{};

    [[nodiscard]] float scale(float size) const { return stbtt_ScaleForMappingEmToPixels(&info, size); }

    [[nodiscard]] float advance(char32_t code, float size) const {
        // Tabular figures: numbers that change must not jump.
        const char32_t measured = code >= U'0' && code <= U'9' ? U'0' : code;
        int width = 0;
        int left = 0;
        stbtt_GetCodepointHMetrics(&info, int(measured), &width, &left);
        return float(width) * scale(size);
    }

    void draw(Image<Rgba8>& image, float x, int baseline, char32_t code, float size, Rgba8 colour) const;
};

namespace {

constexpr int dot_columns = 6;  // five and a gap

/// Pixels per dot of the built-in letters.
int dot_size(float size) { return std::max(1, int(std::lround(double(size) / 11.0))); }

bool is_thin_space(char32_t code) { return code == U'\u2009' || code == U'\u202f'; }

int dot_advance(char32_t code, float size) { return dot_size(size) * (is_thin_space(code) ? 3 : dot_columns); }

void blend_pixel(Image<Rgba8>& image, int x, int y, Rgba8 colour, float coverage) {
    if (!image.contains(x, y)) return;
    Rgba8& pixel = image.at(x, y);
    const Rgba8 over{colour.r, colour.g, colour.b, 255};
    pixel = mix(pixel, over, coverage * float(colour.a) / 255.0f);
}

void draw_dots(Image<Rgba8>& image, int x, int baseline, char32_t code, float size, Rgba8 colour) {
    const int dot = dot_size(size);
    const DotGlyph& glyph = dot_glyph(code);
    for (int row = 0; row < 7 * dot; ++row) {
        for (int column = 0; column < 5 * dot; ++column) {
            const bool set = (glyph[static_cast<std::size_t>(row / dot)] >> (4 - column / dot) & 1) != 0;
            if (set) blend_pixel(image, x + column, baseline - 7 * dot + row, colour, 1);
        }
    }
}

}  // namespace

void Font::Face::draw(Image<Rgba8>& image, float x, int baseline, char32_t code, float size, Rgba8 colour) const {
    const float factor = scale(size);
    // A digit narrower than the common width stands in its middle.
    int width = 0;
    int left = 0;
    stbtt_GetCodepointHMetrics(&info, int(code), &width, &left);
    const float start = x + (advance(code, size) - float(width) * factor) / 2;
    const int column = int(std::floor(start));
    const float shift = start - float(column);

    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetCodepointBitmapBoxSubpixel(&info, int(code), factor, factor, shift, 0, &x0, &y0, &x1, &y1);
    if (x1 <= x0 || y1 <= y0) return;
    Image<unsigned char> coverage(x1 - x0, y1 - y0);
    stbtt_MakeCodepointBitmapSubpixel(&info, coverage.pixels.data(), coverage.width, coverage.height, coverage.width,
                                      factor, factor, shift, 0, int(code));
    for (int row = 0; row < coverage.height; ++row) {
        for (int i = 0; i < coverage.width; ++i) {
            blend_pixel(image, column + x0 + i, baseline + y0 + row, colour, float(coverage.at(i, row)) / 255.0f);
        }
    }
}

Font Font::from_bytes(std::span<const std::byte> bytes) {
    auto face = std::make_shared<Face>();
    face->bytes.resize(bytes.size());
    if (!bytes.empty()) std::memcpy(face->bytes.data(), bytes.data(), bytes.size());
    // Shorter than any table directory: the reader would run past the end.
    const int offset = bytes.size() < 512 ? -1 : stbtt_GetFontOffsetForIndex(face->bytes.data(), 0);
    if (offset < 0 || stbtt_InitFont(&face->info, face->bytes.data(), offset) == 0) {
        throw InputError("font: not a TrueType or OpenType face; give a .ttf or .otf file");
    }
    Font font;
    font.face_ = std::move(face);
    return font;
}

int Font::ascent(float size) const {
    if (!face_) return 7 * dot_size(size) + 1;
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&face_->info, &ascent, &descent, &gap);
    return int(std::ceil(float(ascent) * face_->scale(size)));
}

int Font::descent(float size) const {
    if (!face_) return 2 * dot_size(size);
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&face_->info, &ascent, &descent, &gap);
    return int(std::ceil(-float(descent) * face_->scale(size)));
}

int Font::line_height(float size) const {
    return std::max(ascent(size) + descent(size), int(std::lround(double(size) * 1.3)));
}

float Font::width(std::string_view text, float size) const {
    float width = 0;
    for (const char32_t code : decode_utf8(text))
        width += face_ ? face_->advance(code, size) : float(dot_advance(code, size));
    return width;
}

void Font::draw(Image<Rgba8>& image, float x, int baseline, std::string_view text, float size, Rgba8 colour) const {
    for (const char32_t code : decode_utf8(text)) {
        if (face_) {
            face_->draw(image, x, baseline, code, size, colour);
            x += face_->advance(code, size);
        } else {
            draw_dots(image, int(std::lround(x)), baseline, code, size, colour);
            x += float(dot_advance(code, size));
        }
    }
}

}  // namespace kd
