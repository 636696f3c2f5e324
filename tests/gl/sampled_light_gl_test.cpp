// Frames of sampled light against what was written elsewhere about the same rays: double precision, and other counts.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/double_path.h"
#include "renderer/measure/frame_judge.h"
#include "renderer/measure/ray_count.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

constexpr int side = 48;

struct Sampled {
    FlatScene scene = test::soft_scene(200, 7);
    KdTree tree = build_tree(scene.triangles, {});
    PinholeCamera camera = pinhole(scene.camera, side, side);
    TraceConfig config{.sampling = {.sample = 2, .seed = 9}};

    [[nodiscard]] Frame trace(const TraceConfig& by) const {
        Frame frame(side, side);
        CpuTracer(scene, tree).trace_frame(by, camera, frame, 2);
        return frame;
    }
};

TEST(SampledLight, IsWhatDoublePrecisionMakesOfTheSameSamples) {
    const Sampled s;
    const Frame found = s.trace(s.config);
    const auto exact = double_frame(s.scene, s.camera, side, side, path_config(s.scene, s.config), 2);
    int unlike = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
        unlike += glm::length(glm::dvec3(found.colour.pixels[i]) - exact.pixels[i]) > 1e-4;
    EXPECT_LE(unlike, 3) << "a ray close to an edge may pass on its other side";
}

TEST(SampledLight, ItsRaysAreFoundAgainInTheFrame) {
    const Sampled s;
    const Frame frame = s.trace(s.config);
    const DoubleOracle oracle(s.scene);
    for (const Pass rays : {Pass::rt_prim, Pass::rt_refl, Pass::rt_indirect}) {
        const JudgedLayer judged = judge_frame(oracle, {frame, s.camera, rays}).value();
        EXPECT_GT(judged.compared(), 100) << ray_names[std::size_t(rays)];
        EXPECT_EQ(judged.wrong(), 0) << ray_names[std::size_t(rays)];
    }
    Frame another = frame;
    ++another.sampling.sample;  // whose facets and directions are others
    EXPECT_GT(judge_frame(oracle, {another, s.camera, Pass::rt_indirect})->wrong(), 100);
    EXPECT_GT(judge_frame(oracle, {another, s.camera, Pass::rt_refl})->wrong(), 100);
}

TEST(RaysCounted, EveryWalkCountsEachRayOnce) {
    const Sampled s;
    for (const Rules rules : {Rules::robust, Rules::as_published})
        for (const TraversalInfo& traversal : traversals()) {
            if (rules != Rules::robust && traversal.published_function.empty()) continue;
            TraceConfig config = s.config;
            config.traversal = traversal.id;
            config.rules = rules;
            config.reflection_depth = 2;
            const Frame frame = s.trace(config);
            // Lost rays make other pictures, so that only primary rays have a number to compare with.
            const auto totals = pass_totals(frame);
            EXPECT_EQ(totals[0].rays, std::uint64_t(side * side)) << traversal.name;
            if (rules != Rules::robust) continue;
            const RayCounts counted = count_rays(s.scene, s.tree, config, s.camera, side, side);
            for (std::size_t pass = 0; pass < pass_count; ++pass) {
                EXPECT_EQ(totals[pass].rays, std::uint64_t(counted[pass])) << traversal.name << ", " << ray_names[pass];
                EXPECT_GT(counted[pass], 0) << ray_names[pass];
            }
        }
}

}  // namespace
}  // namespace kd
