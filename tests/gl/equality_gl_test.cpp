// The CPU and OpenGL run the same text: hits and counters agree bit for bit, on every layer.
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;
using test::whole;

/// Highlights use pow, which rounds differently on every machine (up to 51 ulp on llvmpipe, numerics of GLSL 4.7.1); all
/// else in a colour is exact. Lights here are below 3 and gloss below 1, so this leaves an ample factor.
constexpr float colour_tolerance = 2e-5f;

constexpr int width = 96;
constexpr int height = 64;

struct Case {
    ContextKind context;
    Traversal traversal;
    LeafLists lists;
};

std::vector<Case> all_cases()
{
    std::vector<Case> cases;
    for (const ContextKind context : {ContextKind::osmesa, ContextKind::egl})
        for (const TraversalInfo& traversal : traversals())
            for (const LeafLists lists : {LeafLists::references, LeafLists::duplicated})
                cases.push_back({context, traversal.id, lists});
    return cases;
}

std::string case_name(const testing::TestParamInfo<Case>& test)
{
    return std::string(name_of(test.param.context)) + "_" + std::string(info(test.param.traversal).name) +
           (test.param.lists == LeafLists::duplicated ? "_duplicated" : "_references");
}

void expect_equal(const Frame& cpu, const Frame& gl)
{
    ASSERT_EQ(cpu.width, gl.width);
    ASSERT_EQ(cpu.height, gl.height);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        int hits = 0, counters = 0;
        for (std::size_t i = 0; i < cpu.colour.pixels.size(); ++i) {
            hits += !bit_equal(cpu.layers[pass].hit.pixels[i], gl.layers[pass].hit.pixels[i]);
            counters += !(cpu.layers[pass].counters.pixels[i] == gl.layers[pass].counters.pixels[i]);
        }
        EXPECT_EQ(hits, 0) << "hits of " << pass_names[pass];
        EXPECT_EQ(counters, 0) << "counters of " << pass_names[pass];
    }
    float worst = 0.0f;
    for (std::size_t i = 0; i < cpu.colour.pixels.size(); ++i) {
        const Vec4 d = glm::abs(cpu.colour.pixels[i] - gl.colour.pixels[i]);
        for (const float x : {d.x, d.y, d.z, d.w}) worst = x <= worst ? worst : x; // NaN becomes the worst
    }
    EXPECT_LE(worst, colour_tolerance);
}

class EqualityGl : public testing::TestWithParam<Case> {
protected:
    void SetUp() override
    {
        try {
            context = Context::create(GetParam().context);
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
        config.trace.traversal = GetParam().traversal;
        config.trace.leaf_lists = GetParam().lists;
    }

    void compare(const FlatScene& scene, const BuildConfig& build)
    {
        const KdTree tree = build_tree(scene.triangles, build);
        const PinholeCamera camera = pinhole(scene.camera, width, height);
        Frame expected(width, height);
        CpuTracer(scene, tree).trace_frame(config.trace, camera, expected, 2);
        GlTracer tracer(*context);
        tracer.upload(scene, tree);
        (void)tracer.draw(config, camera, width, height, whole(width, height));
        expect_equal(expected, tracer.read_frame(config.trace));
    }

    std::unique_ptr<Context> context;
    GlTraceConfig config;
};
INSTANTIATE_TEST_SUITE_P(All, EqualityGl, testing::ValuesIn(all_cases()), case_name);

TEST_P(EqualityGl, OneBounce)
{
    compare(test::mirror_scene(500, 7), {});
}

TEST_P(EqualityGl, ThreeBouncesAsPublished)
{
    config.trace.reflection_depth = 3;
    config.early_z = EarlyZ::as_published;
    compare(test::mirror_scene(100, 8), {});
}

TEST_P(EqualityGl, ThreeBouncesCulled)
{
    config.trace.reflection_depth = 3;
    compare(test::mirror_scene(100, 8), {});
}

TEST_P(EqualityGl, LargeLeavesWithoutShadows)
{
    config.trace.shadows = false;
    compare(test::mirror_scene(300, 9), {.leaf_size = 16});
}

TEST_P(EqualityGl, AxisAlignedCity)
{
    // Split planes lie in the triangles, and the camera looks along an axis from inside a lattice plane.
    FlatScene scene = test::scene_of(test::voxel_city(4));
    scene.camera = {Vec3(2, 2, 12), Vec3(2, 2, 0), Vec3(0, 1, 0), 40.0f};
    compare(scene, {});
}

TEST_P(EqualityGl, EmptyScene)
{
    FlatScene scene = test::scene_of({});
    scene.camera = {};
    compare(scene, {});
}

} // namespace
} // namespace kd
