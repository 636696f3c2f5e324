// Text on images.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/geometry/image.h"

namespace kd {

/// A typeface at any size. The default one is built in: capitals, digits and signs of 5x7 dots, so that no picture ever
/// lacks its numbers. Copies share the data. Digits all have the same width. Sizes are in pixels per em.
class Font {
  public:
    Font() = default;
    /// The first face of a TrueType or OpenType file, whose bytes are copied; trusted files only. InputError where it
    /// is none.
    [[nodiscard]] static Font from_bytes(std::span<const std::byte> bytes);

    /// Baseline to the top of the tallest letters; baseline to the bottom of the deepest, positive; baseline to
    /// baseline.
    [[nodiscard]] int ascent(float size) const;
    [[nodiscard]] int descent(float size) const;
    [[nodiscard]] int line_height(float size) const;
    /// Width of a line of UTF-8 text in pixels.
    [[nodiscard]] float width(std::string_view text, float size) const;

    /// Draws a line of UTF-8 text with its left end at (x, baseline), clipped to the image. Bytes that are not UTF-8
    /// show as the replacement character.
    void draw(Image<Rgba8>& image, float x, int baseline, std::string_view text, float size, Rgba8 colour) const;

  private:
    struct Face;
    std::shared_ptr<const Face> face_;
};

/// Lines no wider than `width` where words allow it; a longer word is broken. Keeps line breaks of the text.
[[nodiscard]] std::vector<std::string> wrap_text(const Font& font, std::string_view text, float size, int width);
/// The same for letters that are all as wide as each other.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text, std::size_t most_letters);
/// The same for any way to say whether a line fits.
[[nodiscard]] std::vector<std::string> wrap_text(std::string_view text,
                                                 const std::function<bool(std::string_view)>& fits);

/// Code points of UTF-8 text, U+FFFD for what is none.
[[nodiscard]] std::u32string decode_utf8(std::string_view text);

}  // namespace kd
