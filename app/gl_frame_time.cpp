#include "app/gl_frame_time.h"

#include <algorithm>

namespace kd {

void add_band(FrameTime& time, const GlFrameReport& band) {
    time.total_ms += band.total_ms;
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        if (band.pass_ms[pass] > 0) time.pass_ms[pass] = std::max(time.pass_ms[pass], 0.0) + band.pass_ms[pass];
        std::int64_t& shaded = time.shaded_pixels[pass];
        if (band.shaded_pixels[pass] >= 0) shaded = std::max(shaded, std::int64_t(0)) + band.shaded_pixels[pass];
    }
}

}  // namespace kd
