// Embree, which shares no line with this project, says the same as the double-precision oracle.

#include <gtest/gtest.h>

#ifndef KD_WITH_EMBREE

TEST(Embree, AgreesWithTheOracle) { GTEST_SKIP() << "Embree 3 is not installed"; }

#else

#include "renderer/measure/oracle.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"
#include "tests/bench/embree_tracer.h"

namespace kd {
namespace {

/// Where the exact hit, or Embree's, lies closer to an edge, either may see past it.
constexpr double clear_of_edges = 1e-4;

/// Of t, between Embree and double precision: the power of two above twice the worst of these rays, 7.6 ulp on
/// ball:1000; Embree multiplies by a reciprocal, whose rounding hangs on the processor.
constexpr double most_ulps = 16;

TEST(Embree, AgreesWithTheOracle) {
    for (const char* name : {"ball:1000", "rooms", "cornell", "scatter:2000", "sheet:1000"}) {
        const FlatScene scene = flatten(*make_procedural(name));
        const std::vector<Ray> rays = pixel_rays(pinhole(scene.camera, 128, 128), 128, 128);
        const std::vector<f64::Hit> exact = DoubleOracle(scene).nearest(rays);
        std::vector<Hit> found(rays.size());
        EmbreeTracer(scene, RTC_SCENE_FLAG_ROBUST).trace(rays, found);
        const HitJudge judge{.most_ulps = most_ulps, .tie_ulps = most_ulps, .margin = clear_of_edges};
        int compared = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const HitError error = judge.judge(found[i], exact[i]);
            EXPECT_FALSE(is_wrong(error.verdict))
                << name << " ray " << i << ": " << name_of(error.verdict) << " by " << error.ulps << " ulp";
            compared += error.verdict == HitVerdict::agrees;
        }
        EXPECT_GT(compared, int(rays.size()) * 9 / 10) << name << ": hardly anything is left in doubt";
    }
}

}  // namespace
}  // namespace kd

#endif
