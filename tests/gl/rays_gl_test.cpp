// Arbitrary rays on OpenGL against the CPU, bit for bit.
#include <algorithm>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::MachineTest;

class RaysGl : public MachineTest {
  protected:
    void compare(const FlatScene& scene, std::span<const Ray> rays, bool any_hit,
                 NodeEncoding nodes = NodeEncoding::float4) {
        const KdTree tree = build_tree(scene.triangles, {});
        CpuTracer cpu(scene, tree);
        GlTracer gl_tracer(*context, mode());
        gl_tracer.upload(scene, tree);
        compare(cpu, gl_tracer, mode(), rays, any_hit, nodes);
        if (!context->is_software() || nodes != NodeEncoding::float4) return;
        // Where they are right already, correcting them changes nothing.
        gl_tracer.correct_rounding(true);
        compare(cpu, gl_tracer, mode(), rays, any_hit);
    }

  private:
    /// Every traversal under every set of rules that it has a form for.
    static std::vector<std::pair<Traversal, Rules>> walks() {
        std::vector<std::pair<Traversal, Rules>> walks;
        for (const TraversalInfo& traversal : traversals())
            for (const RulesInfo& rules : all_rules())
                if (rules.id == Rules::robust || traversal.has_published_form())
                    walks.emplace_back(traversal.id, rules.id);
        return walks;
    }

    /// The CPU walks nodes of 16 bytes, OpenGL `nodes`.
    static void compare(CpuTracer& cpu, GlTracer& gl_tracer, GlMode mode, std::span<const Ray> all, bool any_hit,
                        NodeEncoding nodes = NodeEncoding::float4) {
        for (const auto& [traversal, rules] : walks()) {
            // Without a stack some published walks never end; under the first edition's rules most of them.
            const bool may_be_endless = rules != Rules::robust && !info(traversal).has(walk_stack);
            const bool most_are = may_be_endless && rules == Rules::first_edition;
            const std::span<const Ray> rays = all.first(most_are ? std::min<std::size_t>(all.size(), 200) : all.size());
            TraceConfig config{.traversal = traversal, .rules = rules};
            if (!has_walk(mode, config)) continue;
            std::vector<Hit> expected(rays.size()), found(rays.size());
            std::vector<RayCounters> expected_counters(rays.size()), counters(rays.size());
            cpu.trace_rays(config, rays, any_hit, expected, expected_counters, 2);
            config.nodes = nodes;
            gl_tracer.trace_rays(config, rays, any_hit, found, counters);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                // llvmpipe ends the loops of such a ray and its neighbours before their budget does, which is told as a
                // step cap too; what was counted until then is another number.
                const bool cut = may_be_endless && counters[i].exit_reason == KD_EXIT_STEP_CAP;
                ASSERT_TRUE(cut || (bit_equal(expected[i], found[i]) && expected_counters[i] == counters[i]))
                    << info(traversal).name << " " << info(rules).name << " ray " << i << " " << test::hex(rays[i]);
            }
        }
    }
};
KD_FOR_ALL_MACHINES(RaysGl);

TEST_P(RaysGl, UnkindRaysThroughASoup) {
    const FlatScene scene = test::scene_of(test::random_soup(300, 0.2f, 11));
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 9000, 12);  // more than two rows
    compare(scene, rays, false);
    compare(scene, rays, true);
}

TEST_P(RaysGl, ThroughNodesOfEightBytes) {
    const FlatScene scene = test::scene_of(test::random_soup(300, 0.2f, 11));
    compare(scene, test::unkind_rays(scene.triangles, 3000, 12), false, NodeEncoding::packed);
}

TEST_P(RaysGl, UnkindRaysThroughACity) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    compare(scene, test::unkind_rays(scene.triangles, 6000, 13), false);
}

TEST_P(RaysGl, KindRaysThroughASoup) {
    const FlatScene scene = test::scene_of(test::random_soup(300, 0.1f, 7));
    test::Random random(31);
    std::vector<Ray> rays;
    for (int i = 0; i < 5000; ++i) rays.push_back({random.point(-1, 2), random.point(-1, 1), 0.0f, KD_T_LIMIT, -1});
    compare(scene, rays, false);
}

TEST_P(RaysGl, RaysInSplitPlanes) {
    // Under the published rules such a plane is met at 0 * infinity: not a number, and no comparison with it is true.
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    std::vector<Ray> rays;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 25; ++i)
            for (const float zero : {0.0f, -0.0f}) {
                Vec3 origin, direction(zero);
                origin[axis] = -1.0f;
                origin[(axis + 1) % 3] = float(i % 5);
                origin[(axis + 2) % 3] = float(i / 5);
                direction[axis] = 1.0f;
                rays.push_back({origin, direction, 0.0f, KD_T_LIMIT, -1});
            }
    compare(scene, rays, false);
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
    GlTracer tracer(*context, mode());
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
