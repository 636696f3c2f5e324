// Every walk with every choice about it finds what brute force finds.

#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/walk_table.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

Frame traced(const FlatScene& scene, const KdTree& tree, const TraceConfig& config) {
    Frame frame(61, 47);  // no whole number of tiles
    CpuTracer(scene, tree).trace_frame(config, pinhole(scene.camera, frame.width, frame.height), frame);
    return frame;
}

/// Pixels whose hit by the rays of `pass` differs in any bit; of shadow rays, whether there is one.
int unlike(const Frame& expected, const Frame& found, Pass pass) {
    int count = 0;
    for (std::size_t i = 0; i < expected.colour.pixels.size(); ++i) {
        const Hit& a = expected.layer(pass).hit.pixels[i];
        const Hit& b = found.layer(pass).hit.pixels[i];
        const bool nearest = pass == Pass::rt_prim || pass == Pass::rt_refl;
        count += nearest ? !bit_equal(a, b) : (a.triangle < 0) != (b.triangle < 0);
    }
    return count;
}

void hold_to_brute_force(const FlatScene& scene) {
    const TraceConfig base{.reflection_depth = 1};
    for (const Builder& builder : builders()) {
        BuildConfig build;
        build.builder = builder.name;
        const KdTree tree = build_tree(scene.triangles, build);
        TraceConfig naive = base;
        naive.traversal = Traversal::naive;
        const Frame expected = traced(scene, tree, naive);
        for (const NodeEncoding nodes : {NodeEncoding::float4, NodeEncoding::packed})
            for (WalkVariant& variant : walk_variants(base)) {
                variant.config.nodes = nodes;
                const Frame found = traced(scene, tree, variant.config);
                for (const Pass pass : {Pass::rt_prim, Pass::shade_prim, Pass::rt_refl, Pass::shade_refl})
                    EXPECT_EQ(unlike(expected, found, pass), 0) << scene.name << ", " << builder.name << ", "
                                                                << variant.name << ", " << ray_names[std::size_t(pass)];
            }
    }
}

TEST(WalkHits, AreThoseOfBruteForceAmongMirrors) { hold_to_brute_force(test::mirror_scene(150, 3)); }

TEST(WalkHits, AreThoseOfBruteForceInABoxWithABall) { hold_to_brute_force(flatten(*make_procedural("ball:1000"))); }

}  // namespace
}  // namespace kd
