// A column of text rows and drawings that grows downwards: how legends are laid out.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/text.h"

namespace kd {

void fill_rectangle(Image<Rgba8>& image, int x0, int y0, int x1, int y1, Rgba8 colour);  // half-open, clipped
void draw_image(Image<Rgba8>& image, int x, int y, const Image<Rgba8>& picture);         // clipped

/// Rows are added, then drawn at once into an image as high as they need.
class Column {
  public:
    /// `font` must outlive it.
    Column(const Font& font, int width, int scale);
    Column(const Column&) = delete;  // blocks refer to it

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int scale() const { return scale_; }
    [[nodiscard]] const Font& font() const { return font_; }

    void gap(int pixels);
    void paragraph(std::string_view text, float size, Rgba8 colour);  // wrapped
    /// Label at the left, value at the right end; with a swatch before the label where its alpha is not 0.
    void row(const std::string& label, const std::string& value, Rgba8 swatch = {0, 0, 0, 0});
    /// A drawing `height` high; `draw` gets the image and the y of its top.
    void drawing(int height, std::function<void(Image<Rgba8>&, int)> draw);

    [[nodiscard]] Image<Rgba8> render(Rgba8 background) const;

  private:
    struct Block {
        int height;
        std::function<void(Image<Rgba8>&, int)> draw;
    };
    const Font& font_;
    int width_;
    int scale_;
    std::vector<Block> blocks_;
};

}  // namespace kd
