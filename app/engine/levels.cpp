#include "app/engine/levels.h"

#include <algorithm>

namespace kd {

void LevelPlan::learn(double milliseconds, int pixels) {
    if (pixels <= 0 || !(milliseconds > 0)) return;
    const double measured = milliseconds / pixels;
    // Follows a slow-down at once and a speed-up half way, so that one lucky frame does not make the next one late.
    ms_per_pixel_ = measured > ms_per_pixel_ ? measured : 0.5 * (measured + ms_per_pixel_);
}

double LevelPlan::predicted_ms(int scale, int width, int height) const {
    return ms_per_pixel_ * scaled_size(width, scale) * scaled_size(height, scale);
}

int LevelPlan::first(int width, int height) const {
    const int limit = std::max(1, std::min(width, height) / 8);
    int scale = ms_per_pixel_ > 0 ? 1 : 16;  // of unknown speed: few pixels, and then it is known
    while (scale < coarsest && predicted_ms(scale, width, height) > first_frame_ms) scale *= 2;
    while (scale > limit && scale > 1) scale /= 2;
    return scale;
}

int LevelPlan::moving(int width, int height) const {
    if (!(ms_per_pixel_ > 0)) return first(width, height);
    int scale = 1;
    while (scale < coarsest && predicted_ms(scale, width, height) > moving_ms) scale *= 2;
    return scale;
}

int LevelPlan::next(int scale, int width, int height) const {
    if (predicted_ms(1, width, height) < direct_ms) return 1;
    return std::max(1, scale / 4);
}

}  // namespace kd
