#include "renderer/measure/stability/case_pictures.h"

#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/pixel_rays.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

bool is_finite(Vec4 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

void check_picture(CaseRun& run, const Subject& subject, const Camera& camera, int width, int height) {
    const PinholeCamera view = pinhole(camera, width, height);
    const std::vector<Ray> rays = pixel_rays(view, width, height);
    const std::vector<Hit> expected = run.loop_hits(subject.scene, rays);
    Expectation e;
    e.known = &expected;
    run.check(subject, rays, e);
    run.each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& row) {
        const Frame frame = machine.frame(trace, view, width, height, run.stop());
        run.check_stop();
        const std::vector<Hit>& hits = frame.layer(Pass::rt_prim).hit.pixels;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool tie = hits[i].t == expected[i].t && (hits[i].triangle >= 0) == (expected[i].triangle >= 0);
            if (!tie || !is_finite(frame.colour.pixels[i]))
                CaseRun::fail(row, fmt::format("picture: ray {}: expected {}; found {}", exact_text(rays[i]),
                                               exact_text(expected[i]), exact_text(hits[i])));
        }
    });
}

}  // namespace kd
