#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "viz/colormap.h"
#include "viz/overlay.h"
#include "viz/projection.h"

namespace kd {
namespace {

constexpr Rgba8 outline_colour{12, 12, 16, 255};
constexpr float outline_strength = 0.75f;
constexpr float hidden_strength = 0.3f;  // of what lies behind the surface, where it shows

/// A line counts as hidden where it is behind the surface by more than this fraction of the depth, plus what the
/// surface's depth changes to the nearest neighbour pixel: lines that lie in a surface stay visible, however steep it
/// is.
constexpr double depth_tolerance = 1e-3;

/// Depths of the surface seen, and up to where a line is visible at each pixel; infinite where nothing was hit.
Image<float> visible_depth(const Projection& projection, const Frame& frame) {
    const Image<Hit>& hits = frame.layer(Pass::rt_prim).hit;
    Image<float> depth(hits.width, hits.height, std::numeric_limits<float>::infinity());
    for (int y = 0; y < hits.height; ++y) {
        for (int x = 0; x < hits.width; ++x) {
            if (hits.at(x, y).triangle >= 0) depth.at(x, y) = float(projection.depth_at(x, y, double(hits.at(x, y).t)));
        }
    }
    Image<float> limit = depth;
    const auto step_to = [&](int x, int y, float from) {
        return depth.contains(x, y) ? std::abs(depth.at(x, y) - from) : std::numeric_limits<float>::infinity();
    };
    for (int y = 0; y < depth.height; ++y) {
        for (int x = 0; x < depth.width; ++x) {
            const float d = depth.at(x, y);
            if (std::isinf(d)) continue;
            // The smaller of the two sides: the other may belong to another surface.
            const float across = std::min(step_to(x - 1, y, d), step_to(x + 1, y, d));
            const float down = std::min(step_to(x, y - 1, d), step_to(x, y + 1, d));
            const float slope = (std::isinf(across) ? 0 : across) + (std::isinf(down) ? 0 : down);
            limit.at(x, y) = d * float(1 + depth_tolerance) + slope;
        }
    }
    return limit;
}

/// What the lines cover of each pixel. Collected first and laid over the image once, so that lines on top of each
/// other do not add up.
struct Ink {
    float line = 0;     // coverage by the line, 0..1
    float outline = 0;  // by the line and its outline
    Rgba8 colour;
};

class LinePainter {
  public:
    LinePainter(const PinholeCamera& camera, const Frame& frame, const OverlayConfig& config,
                std::span<const Rgba8> of_node)
        : projection_(camera, frame.width, frame.height), limit_(visible_depth(projection_, frame)), config_(config),
          of_node_(of_node), ink_(frame.width, frame.height) {}

    void add(const WorldLine& line) {
        const auto segment = projection_.project_segment(line.a, line.b);
        if (!segment) return;
        const double dx = segment->b.x - segment->a.x;
        const double dy = segment->b.y - segment->a.y;
        const Rgba8 colour =
            of_node_.empty() ? depth_colour(line.depth, config_.max_depth) : of_node_[std::size_t(line.node)];
        if (std::abs(dx) >= std::abs(dy)) {
            walk<true>(segment->a, segment->b, colour);
        } else {
            walk<false>(segment->a, segment->b, colour);
        }
    }

    void apply(Image<Rgba8>& image) const {
        for (std::size_t i = 0; i < ink_.pixels.size(); ++i) {
            const Ink& ink = ink_.pixels[i];
            if (ink.outline <= 0) continue;
            const Rgba8 under = mix(image.pixels[i], outline_colour, ink.outline * outline_strength * config_.opacity);
            image.pixels[i] = mix(under, ink.colour, ink.line * config_.opacity);
        }
    }

  private:
    /// Visits the pixels along the major axis (x where `flat`), and across it the few that line and outline touch.
    template <bool flat>
    void walk(PixelPoint a, PixelPoint b, Rgba8 colour) {
        const auto major = [](const PixelPoint& p) { return flat ? p.x : p.y; };
        const auto minor = [](const PixelPoint& p) { return flat ? p.y : p.x; };
        if (major(a) > major(b)) std::swap(a, b);
        const double length = major(b) - major(a);
        const double slope = length > 0 ? (minor(b) - minor(a)) / length : 0;
        const double across = 1 / std::sqrt(1 + slope * slope);  // distance to the line per pixel of minor axis
        const int first = int(std::floor(major(a)));
        const int last = int(std::floor(major(b)));
        for (int i = first; i <= last; ++i) {
            const double s = length > 0 ? std::clamp((i + 0.5 - major(a)) / length, 0.0, 1.0) : 0.5;
            const double centre = minor(a) + s * (minor(b) - minor(a));
            // 1/depth is linear in the picture.
            const double depth = 1 / ((1 - s) / a.depth + s / b.depth);
            const int middle = int(std::floor(centre));
            // Decided once for the width of the line, so that its outline does not fray on a slanted surface.
            const bool hidden = flat ? is_hidden(i, middle, depth) : is_hidden(middle, i, depth);
            if (hidden && config_.hidden_line) continue;
            const float strength = hidden ? hidden_strength : 1.0f;
            for (int j = middle - 2; j <= middle + 2; ++j) {
                const double distance = std::abs(j + 0.5 - centre) * across;
                if (flat) {
                    mark(i, j, distance, strength, colour);
                } else {
                    mark(j, i, distance, strength, colour);
                }
            }
        }
    }

    [[nodiscard]] bool is_hidden(int x, int y, double depth) const {
        return depth > double(limit_.at(std::clamp(x, 0, limit_.width - 1), std::clamp(y, 0, limit_.height - 1)));
    }

    void mark(int x, int y, double distance, float strength, Rgba8 colour) {
        if (distance >= 2 || !ink_.contains(x, y)) return;
        const float line = strength * float(std::clamp(1.25 - distance, 0.0, 1.0));
        Ink& ink = ink_.at(x, y);
        ink.outline = std::max(ink.outline, strength * float(std::min(2 - distance, 1.0)));
        // The same coverage goes to the line drawn later.
        if (line > 0 && line >= ink.line) {
            ink.line = line;
            ink.colour = colour;
        }
    }

    Projection projection_;
    Image<float> limit_;
    const OverlayConfig& config_;
    std::span<const Rgba8> of_node_;
    Image<Ink> ink_;
};

}  // namespace

Rgba8 depth_colour(int depth, int max_depth) {
    static const Colormap& plasma = get_colormap("plasma");
    const float share = max_depth > 0 ? std::clamp(float(depth) / float(max_depth), 0.0f, 1.0f) : 0.0f;
    return plasma(0.97f - 0.67f * share);
}

void draw_lines(Image<Rgba8>& image, const std::vector<WorldLine>& lines, const PinholeCamera& camera,
                const Frame& frame, const OverlayConfig& config, std::span<const Rgba8> of_node) {
    assert(image.width == frame.width && image.height == frame.height);
    if (image.empty()) return;
    LinePainter painter(camera, frame, config, of_node);
    // Backwards, so that the first lines, the shallow ones, are on top.
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) painter.add(*line);
    painter.apply(image);
}

}  // namespace kd
