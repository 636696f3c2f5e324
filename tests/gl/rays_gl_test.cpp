// Arbitrary rays on OpenGL against the CPU, bit for bit.
#include <algorithm>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

class RaysGl : public ContextTest {
  protected:
    void compare(const FlatScene& scene, std::span<const Ray> rays, bool any_hit) {
        const KdTree tree = build_tree(scene.triangles, {});
        CpuTracer cpu(scene, tree);
        GlTracer gl_tracer(*context);
        gl_tracer.upload(scene, tree);
        compare(cpu, gl_tracer, rays, any_hit);
        if (!context->is_software()) return;
        // Where they are right already, correcting them changes nothing.
        gl_tracer.correct_rounding(true);
        compare(cpu, gl_tracer, rays, any_hit);
    }

  private:
    static void compare(CpuTracer& cpu, GlTracer& gl_tracer, std::span<const Ray> rays, bool any_hit) {
        for (const TraversalInfo& traversal : traversals()) {
            TraceConfig config{.traversal = traversal.id};
            std::vector<Hit> expected(rays.size()), found(rays.size());
            std::vector<RayCounters> expected_counters(rays.size()), counters(rays.size());
            cpu.trace_rays(config, rays, any_hit, expected, expected_counters, 2);
            gl_tracer.trace_rays(config, rays, any_hit, found, counters);
            for (std::size_t i = 0; i < rays.size(); ++i)
                ASSERT_TRUE(bit_equal(expected[i], found[i]) && expected_counters[i] == counters[i])
                    << traversal.name << " ray " << i << " " << test::hex(rays[i]);
        }
    }
};
KD_FOR_ALL_CONTEXTS(RaysGl);

TEST_P(RaysGl, UnkindRaysThroughASoup) {
    const FlatScene scene = test::scene_of(test::random_soup(300, 0.2f, 11));
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 9000, 12);  // more than two rows
    compare(scene, rays, false);
    compare(scene, rays, true);
}

TEST_P(RaysGl, UnkindRaysThroughACity) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    compare(scene, test::unkind_rays(scene.triangles, 6000, 13), false);
}

TEST_P(RaysGl, RaysThatAreNone) {
    const FlatScene scene = test::scene_of(test::random_soup(50, 0.2f, 2));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<Ray> rays{
        {Vec3(0), Vec3(0), 0, 1, -1},          {Vec3(nan, 0, 0), Vec3(1, 0, 0), 0, 1, -1},
        {Vec3(0), Vec3(0, nan, 1), 0, 1, -1},  {Vec3(inf, 0, 0), Vec3(-1, 0, 0), 0, 1, -1},
        {Vec3(0), Vec3(0, 0, -inf), 0, 1, -1}, {Vec3(0), Vec3(1, 0, 0), 2, 1, -1},
        {Vec3(0), Vec3(1, 0, 0), nan, 1, -1},  {Vec3(0), Vec3(1, 1, 1), 0, inf, -1},
        {Vec3(-2), Vec3(1, 1, 1), 0, 9, 17},   {Vec3(0.5f), Vec3(-0.0f, 1, -0.0f), 0, 1e-30f, 3},
        {Vec3(0), Vec3(1, 0, 0), 0, nan, -1},  {Vec3(0), Vec3(nan), 0, 1, -1},
    };
    compare(scene, rays, false);
}

TEST_P(RaysGl, WithoutCounters) {
    const FlatScene scene = test::scene_of(test::random_soup(100, 0.3f, 4));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 100, 5);
    GlTracer tracer(*context);
    tracer.upload(scene, tree);
    std::vector<Hit> counted(rays.size()), plain(rays.size());
    std::vector<RayCounters> counters(rays.size());
    tracer.trace_rays({}, rays, false, counted, counters);
    tracer.trace_rays({}, rays, false, plain, {});
    EXPECT_TRUE(std::ranges::equal(counted, plain, bit_equal));
    EXPECT_GT(std::ranges::count_if(plain, [](const Hit& h) { return h.triangle >= 0; }), 10);
    tracer.trace_rays({}, {}, false, {}, {});  // none at all
}

}  // namespace
}  // namespace kd
