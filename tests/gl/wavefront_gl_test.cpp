// What is peculiar to rays with their state in buffers: refusals, parts of tiles, and what is kept.
#include <fmt/format.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/geometry/input_error.h"
#include "renderer/gl/object.h"
#include "renderer/gl/ray_queues.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"
#include "tests/support/environment_variable.h"
#include "tests/support/refusal.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;
using test::refusal;
using test::whole;

constexpr int width = 40, height = 30;

TEST(RayQueues, RefuseWalksWithoutSteps) {
    EXPECT_EQ(refusal([] { check_wavefront({}); }), "accepted");
    EXPECT_EQ(
        refusal([] { check_wavefront({.traversal = Traversal::naive}); }),
        "tracer gl-wavefront: has no naive under robust rules, but each walk of the tree under robust ones; choose "
        "one of these, or --tracer gl-compute");
    EXPECT_NE(refusal([] { check_wavefront({.rules = Rules::as_published}); }).find("as-published"), std::string::npos);
}

TEST(RayQueues, AStackTakesThreeWordsALevel) {
    SceneNeeds needs;
    needs.levels = 20;
    const int stackless = words_per_ray({.traversal = Traversal::restart}, needs);
    EXPECT_EQ(words_per_ray({}, needs), RayWords::stack + 3 * 20);
    EXPECT_EQ(words_per_ray({.traversal = Traversal::short_stack, .short_stack = 3}, needs), stackless + 4 * 3);
}

class WavefrontGl : public ContextTest {
  protected:
    Frame by_cpu() {
        Frame frame(width, height);
        CpuTracer(scene, tree).trace_frame(config.trace, camera, frame, 2);
        return frame;
    }

    void expect_equal(GlTracer& tracer) {
        const Frame expected = by_cpu();
        (void)tracer.draw(config, camera, width, height, whole(width, height));
        const Frame found = tracer.read_frame(config.trace);
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            const RayLayer &a = found.layers[pass], &b = expected.layers[pass];
            EXPECT_TRUE(std::ranges::equal(a.hit.pixels, b.hit.pixels, bit_equal)) << pass_names[pass];
            EXPECT_TRUE(std::ranges::equal(a.counters.pixels, b.counters.pixels)) << pass_names[pass];
        }
    }

    FlatScene scene = test::mirror_scene(200, 7);
    KdTree tree = build_tree(scene.triangles, {});
    PinholeCamera camera = pinhole(scene.camera, width, height);
    GlTraceConfig config;
};
KD_FOR_ALL_CONTEXTS(WavefrontGl);

TEST_P(WavefrontGl, APictureOfMorePixelsThanThereAreSlotsIsMadeInParts) {
    // Of a hundred words a ray, four rays; two lights leave two pixels at a time.
    GLint64 bytes = 0;
    {
        const test::Variable fault("KDSCOPE_FAULT", "storage:90000");
        const auto small = Context::create(GetParam());
        small->gl().GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
        ASSERT_EQ(bytes, 90000);
        GlTracer tracer(*small, GlMode::wavefront);
        tracer.upload(scene, tree);
        expect_equal(tracer);
        EXPECT_LE(tracer.memory().rays, 2 * bytes);
        EXPECT_GT(tracer.memory().rays, bytes / 2);
    }
    context->make_current();
}

TEST_P(WavefrontGl, WithoutShadowsShadingWalksNowhere) {
    config.trace.shadows = false;
    GlTracer tracer(*context, GlMode::wavefront);
    tracer.upload(scene, tree);
    expect_equal(tracer);
}

TEST_P(WavefrontGl, RefusedWalksLeaveTheTracerUsable) {
    GlTracer tracer(*context, GlMode::wavefront);
    tracer.upload(scene, tree);
    config.trace.rules = Rules::as_published;
    EXPECT_THROW((void)tracer.draw(config, camera, width, height, whole(width, height)), InputError);
    EXPECT_THROW(tracer.prepare(config, width, height), InputError);
    std::vector<Hit> hits(1);
    const std::vector<Ray> rays{{Vec3(0), Vec3(0, 0, 1), 0, 1, -1}};
    EXPECT_THROW(tracer.trace_rays(config.trace, rays, false, hits, {}), InputError);
    config.trace.rules = Rules::robust;
    expect_equal(tracer);
}

TEST_P(WavefrontGl, EveryKindOfShadersLeavesNothingBehindAndCompilesOnce) {
    for (const GlMode mode : gl_modes) {
        const auto before = count_objects(gl());
        {
            GlTracer tracer(*context, mode);
            int compiled = 0;
            tracer.tell_compiling([&](int programs) { compiled = std::max(compiled, programs); });
            tracer.upload(scene, tree);
            tracer.prepare(config, width, height);
            EXPECT_GT(compiled, 0) << tracer_name(mode);
            compiled = 0;
            (void)tracer.draw(config, camera, width, height, whole(width, height));
            tracer.prepare(config, width, height);
            EXPECT_EQ(compiled, 0) << tracer_name(mode);
        }
        EXPECT_EQ(count_objects(gl()), before) << tracer_name(mode);
    }
}

}  // namespace
}  // namespace kd
