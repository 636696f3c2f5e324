#include "renderer/gl/dispatch_plan.h"

#include <algorithm>

namespace kd {

namespace {

constexpr double most_growth = 4;  // from tile to tile, so that one that was easy by chance does not decide
constexpr double most_pixels = 1e9;

}  // namespace

Tile DispatchPlan::next(std::int64_t done, int width, int height) const {
    const int x = int(done % width);
    const int y = int(done / width);
    const auto pixels = std::int64_t(pixels_);
    if (x > 0 || pixels < width)
        return {x, y, int(std::min<std::int64_t>(width, x + std::max<std::int64_t>(1, pixels))), y + 1};
    return {0, y, width, int(std::min<std::int64_t>(height, y + pixels / width))};
}

void DispatchPlan::learn(double milliseconds, const Tile& tile) {
    const double pixels = double(tile.x1 - tile.x0) * double(tile.y1 - tile.y0);
    if (pixels <= 0) return;
    const double fits = milliseconds > 0 ? wanted_ms_ / milliseconds * pixels : most_pixels;
    // A last tile may be smaller than asked for, and says little about larger ones.
    pixels_ = std::clamp(fits, 1.0, std::min(most_growth * std::max(pixels_, pixels), most_pixels));
}

}  // namespace kd
