// Early z culls exactly the pixels that a pass need not shade, and changes no picture.
#include <numeric>

#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;
using test::whole;

constexpr int width = 80;
constexpr int height = 60;

std::size_t at(Pass pass) { return static_cast<std::size_t>(pass); }

class EarlyZGl : public ContextTest {
  protected:
    void SetUp() override {
        ContextTest::SetUp();
        if (!context) return;
        scene = test::mirror_scene(60, 3);
        tree = build_tree(scene.triangles, {});
        camera = pinhole(scene.camera, width, height);
        tracer = std::make_unique<GlTracer>(*context);
        tracer->upload(scene, tree);
        config.count_shaded = true;
    }
    void TearDown() override { tracer.reset(); }

    GlFrameReport draw() { return tracer->draw(config, camera, width, height, whole(width, height)); }

    FlatScene scene;
    KdTree tree;
    PinholeCamera camera;
    std::unique_ptr<GlTracer> tracer;
    GlTraceConfig config;
};
KD_FOR_ALL_CONTEXTS(EarlyZGl);

TEST_P(EarlyZGl, ShadesExactlyTheActivePixels) {
    const GlFrameReport report = draw();
    const Frame frame = tracer->read_frame(config.trace);
    std::int64_t hits = 0, reflective = 0;
    for (const Hit& hit : frame.layer(Pass::rt_prim).hit.pixels) {
        if (hit.triangle < 0) continue;
        ++hits;
        const Vec3 r = scene.materials[std::size_t(scene.attributes[std::size_t(hit.triangle)].material)].reflectance;
        reflective += std::max({r.x, r.y, r.z}) >= config.trace.least_contribution;
    }
    // The scene has pixels of every kind, or this test would prove little.
    ASSERT_GT(reflective, 100);
    ASSERT_GT(hits, reflective + 100);
    ASSERT_GT(width * height, hits + 100);
    EXPECT_EQ(report.shaded_pixels[at(Pass::rt_prim)], width * height);
    EXPECT_EQ(report.shaded_pixels[at(Pass::shade_prim)], hits);
    EXPECT_EQ(report.shaded_pixels[at(Pass::rt_refl)], reflective);
    EXPECT_EQ(report.shaded_pixels[at(Pass::shade_refl)], reflective);
}

TEST_P(EarlyZGl, AsPublishedShadesEveryPixel) {
    config.early_z = EarlyZ::as_published;
    const GlFrameReport report = draw();
    for (int pass = 0; pass < pass_count; ++pass)
        EXPECT_EQ(report.shaded_pixels[std::size_t(pass)], of_indirect_light(Pass(pass)) ? -1 : width * height);
}

TEST_P(EarlyZGl, MarksPathsThatEnd) {
    config.trace.reflection_depth = 2;
    const GlFrameReport two = draw();
    config.trace.reflection_depth = 1;
    const GlFrameReport one = draw();
    const std::int64_t second = two.shaded_pixels[at(Pass::rt_refl)] - one.shaded_pixels[at(Pass::rt_refl)];
    EXPECT_GT(second, 0);
    EXPECT_LT(second, one.shaded_pixels[at(Pass::rt_refl)]);
    EXPECT_EQ(two.shaded_pixels[at(Pass::shade_refl)] - one.shaded_pixels[at(Pass::shade_refl)], second);
}

TEST_P(EarlyZGl, ChangesNoPicture) {
    config.count_shaded = false;
    for (const int depth : {1, 4}) {
        config.trace.reflection_depth = depth;
        config.early_z = EarlyZ::working;
        (void)draw();
        const Frame working = tracer->read_frame(config.trace);
        config.early_z = EarlyZ::as_published;
        (void)draw();
        const Frame published = tracer->read_frame(config.trace);
        EXPECT_EQ(working.colour, published.colour) << depth;
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            EXPECT_TRUE(
                std::ranges::equal(working.layers[pass].hit.pixels, published.layers[pass].hit.pixels, bit_equal))
                << pass_names[pass] << " at depth " << depth;
    }
}

TEST_P(EarlyZGl, CountingChangesNoPicture) {
    (void)draw();
    const Frame counted = tracer->read_frame(config.trace);
    config.count_shaded = false;
    const GlFrameReport report = draw();
    EXPECT_EQ(report.shaded_pixels, for_each_pass<std::int64_t>(-1));
    EXPECT_EQ(tracer->read_frame(config.trace).colour, counted.colour);
}

TEST_P(EarlyZGl, NothingReflectiveMeansNoReflectionPasses) {
    for (Material& m : scene.materials) m.reflectance = Vec3(0);
    tracer->upload(scene, tree);
    const GlFrameReport report = draw();
    for (const Pass pass : {Pass::rt_refl, Pass::shade_refl}) {
        EXPECT_EQ(report.pass_ms[at(pass)], 0.0);
        EXPECT_EQ(report.shaded_pixels[at(pass)], -1);
    }
    EXPECT_GT(report.pass_ms[at(Pass::shade_prim)], 0.0);
    const Frame frame = tracer->read_frame(config.trace);
    for (const Hit& hit : frame.layer(Pass::rt_refl).hit.pixels) ASSERT_EQ(hit.triangle, -1);
}

TEST_P(EarlyZGl, DepthZeroMeansNoReflectionPasses) {
    config.trace.reflection_depth = 0;
    const GlFrameReport report = draw();
    EXPECT_EQ(report.pass_ms[at(Pass::rt_refl)], 0.0);
    EXPECT_EQ(report.shaded_pixels[at(Pass::shade_refl)], -1);
}

}  // namespace
}  // namespace kd
