#include "viz/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "viz/text.h"

namespace kd {

namespace {

/// A rectangle by its middle and half its sides.
struct Box {
    double x, y, half_width, half_height;

    /// Those that only touch do not meet.
    [[nodiscard]] bool meets(const Box& other) const {
        constexpr double touch = 1e-3;
        return std::abs(x - other.x) < half_width + other.half_width - touch &&
               std::abs(y - other.y) < half_height + other.half_height - touch;
    }
};

/// Right or left, above or below; 0 is neither.
constexpr std::array<std::array<int, 2>, 8> sides{
    {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}}};

}  // namespace

std::vector<PlacedLabel> place_labels(const Chart& chart, const LabelSizes& sizes) {
    const auto mark = [&](std::size_t curve, const ChartPoint& point) {
        return Box{sizes.plane_width * chart.x.position(mark_x(chart, curve, point)),
                   sizes.plane_height * chart.y.position(point.y), sizes.mark_radius, sizes.mark_radius};
    };
    std::vector<Box> taken;
    for (std::size_t c = 0; c < chart.curves.size(); ++c)
        if (marker_of(chart.curves[c]) != Marker::none)
            for (const ChartPoint& point : chart.curves[c].points) taken.push_back(mark(c, point));
    std::vector<PlacedLabel> placed;
    for (std::size_t c = 0; c < chart.curves.size(); ++c)
        for (std::size_t p = 0; p < chart.curves[c].points.size(); ++p) {
            const ChartPoint& point = chart.curves[c].points[p];
            if (point.label.empty()) continue;
            const Box at = mark(c, point);
            const double half_width = 0.5 * sizes.letter_width * double(decode_utf8(point.label).size());
            const double half_height = 0.5 * sizes.letter_height;
            for (const auto& [right, up] : sides) {
                const Box label{at.x + right * (sizes.mark_radius + half_width),
                                at.y + up * (sizes.mark_radius + half_height), half_width, half_height};
                if (std::ranges::any_of(taken, [&](const Box& other) { return label.meets(other); })) continue;
                taken.push_back(label);
                placed.push_back({c, p, label.x - at.x, label.y - at.y});
                break;
            }
        }
    return placed;
}

}  // namespace kd
