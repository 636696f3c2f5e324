#include "app/frame/frame_time.h"

#include <algorithm>

namespace kd {

namespace {

template <class T>
void add_known(std::array<T, pass_count>& sum, const std::array<T, pass_count>& more) {
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (more[pass] >= 0) sum[pass] = std::max(sum[pass], T(0)) + more[pass];
}

}  // namespace

void FrameTime::add(const FrameTime& more) {
    total_ms += more.total_ms;
    wall_ms += more.wall_ms;
    add_known(pass_ms, more.pass_ms);
    add_known(shaded_pixels, more.shaded_pixels);
    complete = complete && more.complete;
}

}  // namespace kd
