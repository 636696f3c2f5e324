#include "viz/canvas.h"

#include <algorithm>

#include "viz/legend.h"

namespace kd {
namespace style = figure_style;

void fill_rectangle(Image<Rgba8>& image, int x0, int y0, int x1, int y1, Rgba8 colour) {
    for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y) {
        for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x) image.at(x, y) = colour;
    }
}

void draw_image(Image<Rgba8>& image, int x, int y, const Image<Rgba8>& picture) {
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            if (image.contains(x + column, y + row)) image.at(x + column, y + row) = picture.at(column, row);
        }
    }
}

Column::Column(const Font& font, int width, int scale) : font_(font), width_(width), scale_(scale) {}

void Column::gap(int pixels) {
    blocks_.push_back({pixels * scale_, [](Image<Rgba8>&, int) {}});
}

void Column::paragraph(std::string_view text, float size, Rgba8 colour) {
    const float pixels = size * float(scale_);
    for (std::string& line : wrap_text(font_, text, pixels, width_)) {
        blocks_.push_back(
            {font_.line_height(pixels), [this, line = std::move(line), pixels, colour](Image<Rgba8>& image, int y) {
                 font_.draw(image, 0, y + font_.ascent(pixels), line, pixels, colour);
             }});
    }
}

void Column::row(const std::string& label, const std::string& value, Rgba8 swatch) {
    const float size = style::small_text * float(scale_);
    const int height = font_.line_height(size) + 2 * scale_;
    const float indent = swatch.a != 0 ? float(20 * scale_) : 0;
    const float both = indent + font_.width(label, size) + float(8 * scale_) + font_.width(value, size);
    if (both > float(width_) && !value.empty() && !label.empty()) {  // the value on a line of its own
        row(label, "", swatch);
        return row("", value);
    }
    drawing(height, [this, label, value, swatch, indent, size, height](Image<Rgba8>& image, int y) {
        const int baseline = y + scale_ + font_.ascent(size);
        if (swatch.a != 0) {
            const int side = 12 * scale_;
            const int top = y + (height - side) / 2;
            fill_rectangle(image, 0, top, side, top + side, style::line);
            fill_rectangle(image, scale_, top + scale_, side - scale_, top + side - scale_, swatch);
        }
        font_.draw(image, indent, baseline, label, size, style::dim_text);
        font_.draw(image, float(width_) - font_.width(value, size), baseline, value, size, style::text);
    });
}

void Column::drawing(int height, std::function<void(Image<Rgba8>&, int)> draw) {
    blocks_.push_back({height, std::move(draw)});
}

Image<Rgba8> Column::render(Rgba8 background) const {
    int height = 0;
    for (const Block& block : blocks_) height += block.height;
    Image<Rgba8> image(width_, height, background);
    int y = 0;
    for (const Block& block : blocks_) {
        block.draw(image, y);
        y += block.height;
    }
    return image;
}

}  // namespace kd
