// Embree, which shares no line with this project, says the same as the double-precision oracle.

#include <gtest/gtest.h>

#include "renderer/measure/oracle.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/peers/peers.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

/// Where the exact hit, or Embree's, lies closer to an edge, either may see past it.
constexpr double clear_of_edges = 1e-4;

/// Of t, between Embree and double precision: the power of two above twice the worst of these rays, 7.6 ulp on
/// ball:1000; Embree multiplies by a reciprocal, whose rounding hangs on the processor.
constexpr double most_ulps = 16;

TEST(Embree, AgreesWithTheOracle) {
    if (peers_version().empty()) GTEST_SKIP() << "Embree 3 is not installed";
    for (const char* name : {"ball:1000", "rooms", "cornell", "scatter:2000", "sheet:1000"}) {
        const FlatScene scene = flatten(*make_procedural(name));
        const std::vector<Ray> rays = pixel_rays(pinhole(scene.camera, 128, 128), 128, 128);
        const std::vector<f64::Hit> exact = DoubleOracle(scene).nearest(rays);
        const HitJudge judge{.most_ulps = most_ulps, .tie_ulps = most_ulps, .margin = clear_of_edges};
        for (const auto& peer : make_peers(scene)) {
            if (!peer->robust()) continue;
            SCOPED_TRACE(std::string(name) + " by " + std::string(peer->name()));
            std::vector<Hit> found(rays.size());
            peer->trace(rays, {}, found);
            int compared = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const HitError error = judge.judge(found[i], exact[i]);
                EXPECT_FALSE(is_wrong(error.verdict))
                    << "ray " << i << ": " << name_of(error.verdict) << " by " << error.ulps << " ulp";
                compared += error.verdict == HitVerdict::agrees;
            }
            EXPECT_GT(compared, int(rays.size()) * 9 / 10) << "hardly anything is left in doubt";
        }
    }
}

}  // namespace
}  // namespace kd
