#include "app/engine_ray_cells.h"

#include <algorithm>

#include "viz/overlay.h"
#include "viz/projection.h"

namespace kd {

namespace {

#include "shaders/shared/vector.glsl"
// After vector.glsl, whose functions it calls.
#include "shaders/shared/camera.glsl"

}  // namespace

std::vector<ScreenLine> ray_cells(const TracedFrame& traced, const PixelReading& reading, int width, int height,
                                  std::size_t most) {
    const PinholeCamera camera = pinhole(traced.camera, width, height);
    const Ray ray = camera_ray(camera, int2(reading.pixel.x, reading.pixel.y), int2(width, height));
    const Hit& hit = reading.primary().hit;
    const float t_end = hit.triangle >= 0 ? hit.t : ray.t_max;
    const Projection projection(camera, width, height);
    std::vector<ScreenLine> lines;
    for (const WorldLine& line : lines_along_ray(traced.world->tree, ray, t_end)) {
        if (lines.size() >= most) break;
        if (const auto s = projection.project_segment(line.a, line.b))
            lines.push_back({float(s->a.x), float(s->a.y), float(s->b.x), float(s->b.y), line.depth});
    }
    return lines;
}

}  // namespace kd
