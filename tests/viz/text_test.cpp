#include "viz/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "renderer/geometry/input_error.h"
#include "tests/viz/synthetic.h"
#include "viz/dot_glyphs.h"

namespace kd {
namespace {

constexpr Rgba8 white{255, 255, 255, 255};

std::vector<Font> fonts() {
    std::vector<Font> all{Font()};
    if (const auto font = test::dejavu()) all.push_back(*font);
    return all;
}

struct Extent {
    int x0 = 1 << 20, y0 = 1 << 20, x1 = -1, y1 = -1;  // of the pixels that are not black; x1 and y1 included
};

Extent extent_of(const Image<Rgba8>& image) {
    Extent e;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) == Rgba8{}) continue;
            e = {std::min(e.x0, x), std::min(e.y0, y), std::max(e.x1, x), std::max(e.y1, y)};
        }
    }
    return e;
}

TEST(Text, StandsOnTheBaselineInsideItsWidth) {
    for (const Font& font : fonts()) {
        for (const float size : {13.0f, 15.0f, 26.0f}) {
            Image<Rgba8> image(400, 80);
            font.draw(image, 20, 50, "HEX", size, white);
            const Extent e = extent_of(image);
            EXPECT_EQ(e.y1, 49) << "letters without descender end right above the baseline";
            EXPECT_GE(e.y0, 50 - font.ascent(size));
            EXPECT_GE(e.x0, 20);
            EXPECT_LE(e.x1, 20 + int(font.width("HEX", size)));
            EXPECT_GT(e.x1 - e.x0, int(size));
        }
    }
}

TEST(Text, DigitsHaveOneWidth) {
    for (const Font& font : fonts()) {
        for (const char* digit : {"1", "4", "7", "8"}) EXPECT_EQ(font.width(digit, 13), font.width("0", 13)) << digit;
        EXPECT_LT(font.width("\u2009", 13), font.width("0", 13)) << "thin space";
    }
}

TEST(Text, WidthGrowsWithTheSize) {
    for (const Font& font : fonts()) {
        EXPECT_GT(font.width("visits", 26), 1.5f * font.width("visits", 13));
        EXPECT_GT(font.line_height(26), font.line_height(13));
        EXPECT_EQ(font.width("", 13), 0.0f);
    }
}

TEST(Text, IsClippedToTheImage) {
    for (const Font& font : fonts()) {
        Image<Rgba8> image(10, 10);
        font.draw(image, -8, 3, "WWWW", 20, white);
        font.draw(image, 5, 30, "WWWW", 20, white);
        EXPECT_NE(extent_of(image).x1, -1);
    }
}

TEST(Text, BuiltInLettersAreExact) {
    Image<Rgba8> image(6, 8);
    Font().draw(image, 0, 7, "1", 13, white);
    const std::array<std::string, 7> one{"..#..", ".##..", "..#..", "..#..", "..#..", "..#..", ".###."};
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 5; ++x) {
            const bool set = one[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
            EXPECT_EQ(image.at(x, y), set ? white : Rgba8{}) << x << "," << y;
        }
    }
}

// All that legends are made of must be there without any font file.
TEST(Text, BuiltInLettersCoverLegends) {
    const DotGlyph& unknown = dot_glyph(U'\u4e00');
    for (const char32_t code :
         decode_utf8("abcxyzABCXYZ0123456789 .,:;+-*/%()<>=#!?'_[]\u2009\u2212\u2013\u00b7\u00d7\u2264")) {
        EXPECT_NE(dot_glyph(code), unknown) << std::uint32_t(code);
    }
    for (char32_t a = U'0'; a <= U'9'; ++a) {
        for (char32_t b = U'A'; b <= U'Z'; ++b) EXPECT_NE(dot_glyph(a), dot_glyph(b));
        for (char32_t b = U'0'; b < a; ++b) EXPECT_NE(dot_glyph(a), dot_glyph(b));
    }
}

TEST(Text, BytesThatAreNoFontAreRefused) {
    const std::vector<std::byte> noise(4096, std::byte{0x5a});
    EXPECT_THROW(static_cast<void>(Font::from_bytes(noise)), InputError);
    EXPECT_THROW(static_cast<void>(Font::from_bytes({})), InputError);
    EXPECT_THROW(static_cast<void>(Font::from_bytes(std::span(noise).first(3))), InputError);
}

TEST(Utf8, DecodesAndReplaces) {
    EXPECT_EQ(decode_utf8("a\u00e9\u2009\U0001f600"), U"a\u00e9\u2009\U0001f600");
    EXPECT_EQ(decode_utf8("\xff"
                          "a"),
              U"\ufffd"
              U"a");
    EXPECT_EQ(decode_utf8("\xc3"), U"\ufffd") << "cut off";
    EXPECT_EQ(decode_utf8("\xc0\x80"), U"\ufffd\ufffd") << "overlong";
    EXPECT_EQ(decode_utf8("\xed\xa0\x80").front(), U'\ufffd') << "surrogate";
    EXPECT_EQ(decode_utf8("\xe2\x80"
                          "a"),
              U"\ufffd\ufffd"
              U"a");
}

TEST(Wrap, BreaksAtSpacesAndInsideLongWords) {
    const Font font;  // 6 pixels per letter
    EXPECT_EQ(wrap_text(font, "one two three", 13, 60), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrap_text(font, "one\ntwo", 13, 600), (std::vector<std::string>{"one", "two"}));
    EXPECT_EQ(wrap_text(font, "abcdefghij", 13, 24), (std::vector<std::string>{"abcd", "efgh", "ij"}));
    EXPECT_EQ(wrap_text(font, "abc", 13, 1), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_TRUE(wrap_text(font, "", 13, 60).empty());
    EXPECT_EQ(wrap_text("one two – three", 9), (std::vector<std::string>{"one two –", "three"}))
        << "letters, not bytes";
    for (const std::string& line : wrap_text(font, "the quick brown fox jumps over the lazy dog", 13, 70)) {
        EXPECT_LE(font.width(line, 13), 70.0f) << line;
    }
}

}  // namespace
}  // namespace kd
