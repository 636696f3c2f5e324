// What the robust rules cost in steps. Counts are the same on every machine; the time is robustness_bench's to measure.

#include <gtest/gtest.h>

#include "renderer/kdtree/build.h"
#include "renderer/measure/pixel_rays.h"
#include "tests/bench/bench_scene.h"
#include "tests/bench/rule_steps.h"

namespace kd {
namespace {

class RobustSteps : public testing::TestWithParam<const char*> {};

TEST_P(RobustSteps, AreAtMostThreePercentMoreThanThePublishedOnes) {
    const FlatScene scene = bench_scene(GetParam());
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = pixel_rays(pinhole(scene.camera, image_size, image_size), image_size, image_size);
    CpuTracer tracer(scene, tree);
    const std::uint64_t robust = stack_steps(tracer, Rules::robust, rays);
    const std::uint64_t published = stack_steps(tracer, Rules::as_published, rays);
    EXPECT_GT(published, rays.size()) << "the rays cross the tree";
    const double share = double(robust) / double(published);
    RecordProperty("share", std::to_string(share));
    EXPECT_LE(share, most_robust_steps) << robust << " and " << published;
}

std::string scene_name(const testing::TestParamInfo<const char*>& test) {
    std::string name = test.param;
    name.erase(name.find(':'));
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, RobustSteps, testing::Values("ball:9000", "scatter:10000"), scene_name);

}  // namespace
}  // namespace kd
