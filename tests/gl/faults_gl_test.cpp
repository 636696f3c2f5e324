// Faults of OpenGL, by their number in docs/stability.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "renderer/geometry/input_error.h"
#include "renderer/gl/dispatch_plan.h"
#include "renderer/gl/pass_timer.h"
#include "renderer/gl/self_test.h"
#include "tests/gl/gl_test.h"
#include "tests/support/environment_variable.h"
#include "tests/support/faulty_shaders.h"

namespace kd {
namespace {

using test::context_name;
using test::shaders_with;
using test::Variable;
using test::whole;

class GlFaults : public testing::TestWithParam<ContextKind> {
  protected:
    void SetUp() override {
        try {
            (void)Context::create(GetParam());
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
    }

    template <class Error>
    static std::string message_of(const std::function<void()>& work) {
        try {
            work();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing was wrong";
    }

    static bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

    std::string message_of_tracer() {
        const auto context = Context::create(GetParam());
        return message_of<GlError>([&] { GlTracer tracer(*context); });
    }

    FlatScene scene = test::mirror_scene(200, 3);
    KdTree tree = build_tree(scene.triangles, {});
};
KD_FOR_ALL_CONTEXTS(GlFaults);

TEST_P(GlFaults, F03_AShaderThatFailsNamesFileAndLineAndThePassesBeforeItStayUsable) {
    const auto context = Context::create(GetParam());
    const std::filesystem::path folder =
        shaders_with("opengl/scene_hooks.glsl", "#if KD_DUPLICATED\n", "#if KD_DUPLICATED\nnonsense();\n");
    const Variable shaders("KD_SHADER_DIR", folder.string());
    GlTracer tracer(*context);
    tracer.upload(scene, tree);
    const PinholeCamera camera = pinhole(scene.camera, 32, 24);
    tracer.draw({}, camera, 32, 24, whole(32, 24));
    const Frame before = tracer.read_frame({});
    GlTraceConfig copies;
    copies.trace.leaf_lists = LeafLists::duplicated;
    const std::string message = message_of<GlError>([&] { tracer.draw(copies, camera, 32, 24, whole(32, 24)); });
    EXPECT_TRUE(holds(message, "does not compile")) << message;
    EXPECT_TRUE(holds(message, "shaders/opengl/scene_hooks.glsl:")) << message;
    EXPECT_TRUE(holds(message, "nonsense")) << message;
    tracer.draw({}, camera, 32, 24, whole(32, 24));
    EXPECT_EQ(tracer.read_frame({}).colour, before.colour);
}

TEST_P(GlFaults, F04_AGoodContextPassesTheSelfTestAndIsLeftEmpty) {
    const auto context = Context::create(GetParam());
    GlTracer tracer(*context);
    EXPECT_EQ(tracer.memory().triangles, 0);
    EXPECT_NO_THROW(self_test(tracer, context->renderer()));
}

TEST_P(GlFaults, F04_AWrongTIsFound) {
    const Variable shaders(
        "KD_SHADER_DIR",
        shaders_with("opengl/rays.glsl", "leave_hit(pixel, hit)", "hit.t *= 1.0001; leave_hit(pixel, hit)").string());
    const std::string message = message_of_tracer();
    EXPECT_TRUE(holds(message, "fails the self-test: ray 1 of ")) << message;
    EXPECT_TRUE(holds(message, "--tracer cpu")) << message;
}

TEST_P(GlFaults, F04_ANanThatIsTakenForANumberIsFound) {
    // What a compiler makes of it that is told that there is no NaN.
    const Variable shaders("KD_SHADER_DIR",
                           shaders_with("shared/ray.glsl",
                                        "!(IS_NAN(a.x) || IS_NAN(a.y) || IS_NAN(a.z)) && abs(a.x) <= limit && "
                                        "abs(a.y) <= limit && abs(a.z) <= limit",
                                        "!(abs(a.x) > limit) && !(abs(a.y) > limit) && !(abs(a.z) > limit)")
                               .string());
    const std::string message = message_of_tracer();
    if (message == "nothing was wrong" && !Context::create(GetParam())->is_software())
        GTEST_SKIP() << "this compiler turns the comparisons round again, and NaN stays no number";
    EXPECT_TRUE(holds(message, "nan")) << message;
    EXPECT_TRUE(holds(message, "invalid ray")) << message;
}

TEST_P(GlFaults, F04_ALostTriangleIsFound) {
    const Variable shaders("KD_SHADER_DIR", shaders_with("opengl/scene_hooks.glsl", "return reference_at(slot);",
                                                         "return reference_at(slot) ^ 1;")
                                                .string());
    EXPECT_TRUE(holds(message_of_tracer(), "fails the self-test"));
}

TEST_P(GlFaults, F05_ASceneBeyondTheLimitIsRefusedWithTheNumbersBeforeItIsUploaded) {
    const Variable fault("KDSCOPE_FAULT", "texels:700,side:64");
    const auto context = Context::create(GetParam());
    GlTracer tracer(*context);
    const FlatScene large = test::mirror_scene(5000, 1);
    const KdTree its_tree = build_tree(large.triangles, {});
    const std::string message = message_of<InputError>([&] { tracer.upload(large, its_tree); });
    EXPECT_TRUE(holds(message, "texels, a texture buffer holds 700 here")) << message;
    EXPECT_EQ(tracer.memory().triangles, 0) << "nothing was uploaded";
    const FlatScene small = test::scene_of(test::random_soup(40, 0.2f, 1));
    const KdTree small_tree = build_tree(small.triangles, {});
    tracer.upload(small, small_tree);
    EXPECT_NO_THROW(tracer.prepare({}, 64, 64));
    EXPECT_TRUE(
        holds(message_of<InputError>([&] { tracer.prepare({}, 65, 4); }), "65x4 pixels: a texture holds 64x64"));
}

TEST_P(GlFaults, F06_MemoryThatRunsOutKeepsTheSceneBefore) {
    const Variable fault("KDSCOPE_FAULT", "memory:100000");
    const auto context = Context::create(GetParam());
    GlTracer tracer(*context);
    tracer.upload(scene, tree);
    const PinholeCamera camera = pinhole(scene.camera, 32, 24);
    tracer.draw({}, camera, 32, 24, whole(32, 24));
    const Frame before = tracer.read_frame({});
    const GlMemory memory = tracer.memory();

    const FlatScene large = test::mirror_scene(9000, 1);
    const KdTree its_tree = build_tree(large.triangles, {});
    const std::string message = message_of<GlError>([&] { tracer.upload(large, its_tree); });
    EXPECT_TRUE(holds(message, "out of memory while uploading")) << message;
    EXPECT_TRUE(holds(message, "bytes of")) << message;
    EXPECT_TRUE(holds(message, "use a smaller scene or picture, or --tracer cpu")) << message;
    EXPECT_EQ(tracer.memory().triangles, memory.triangles);

    EXPECT_TRUE(holds(message_of<GlError>([&] { tracer.prepare({}, 200, 200); }), "a texture of 200x200 pixels"));
    tracer.draw({}, camera, 32, 24, whole(32, 24));
    EXPECT_EQ(tracer.read_frame({}).colour, before.colour) << "the scene before is still there";
}

TEST_P(GlFaults, F08_AContextThatIsLostIsToldAsSuch) {
    const Variable fault("KDSCOPE_FAULT", "lost:1");
    const auto draw_often = [&](GlTracer& tracer) {
        tracer.upload(scene, tree);
        for (int i = 0; i < 20; ++i) tracer.draw({}, pinhole(scene.camera, 16, 12), 16, 12, whole(16, 12));
    };
    {
        const auto context = Context::create(GetParam());
        GlTracer lost(*context);
        EXPECT_TRUE(holds(message_of<ContextLost>([&] { draw_often(lost); }), "the GPU was reset while"));
        EXPECT_THROW(draw_often(lost), ContextLost) << "for good";
    }
    const auto context = Context::create(GetParam());
    GlTracer good(*context);
    EXPECT_NO_THROW(draw_often(good));
}

TEST_P(GlFaults, F16_WithoutTimerQueriesTheWallClockIsReadAndNamed) {
    const auto context = Context::create(GetParam());
    GlApi gl = context->gl();
    const auto clock_of = [&] {
        PassTimer timer(gl, false);
        GlFrameReport report;
        timer.begin_frame();
        timer.begin(Pass::rt_prim);
        timer.end();
        timer.end_frame(report);
        EXPECT_GE(report.total_ms, report.pass_ms[0]);
        return report.clock;
    };
    EXPECT_EQ(clock_of(), "timer query");
    gl.GetQueryiv = [](GLenum, GLenum, GLint* bits) { *bits = 0; };
    EXPECT_EQ(clock_of(), "finish + steady clock");
}

TEST_P(GlFaults, F17_TextureCoordinatesThatAreNoPlaceReadTheImagesCorner) {
    const auto context = Context::create(GetParam());
    GlTracer tracer(*context);
    FlatScene textured = test::mirror_scene(60, 2);
    const KdTree its_tree = build_tree(textured.triangles, {});
    const PinholeCamera camera = pinhole(textured.camera, 48, 36);
    const auto picture_with = [&](const std::array<Vec2, 3>& uv) {
        for (TriangleAttributes& a : textured.attributes) std::ranges::copy(uv, a.uv);
        tracer.upload(textured, its_tree);
        tracer.draw({}, camera, 48, 36, whole(48, 36));
        return tracer.read_frame({}).colour;
    };
    const Vec2 corner(0.0f), middle(0.5f);
    const Image<Vec4> expected = picture_with({corner, corner, corner});
    ASSERT_NE(picture_with({middle, middle, middle}), expected) << "the image is seen, and is not of one colour";
    // Beyond 2^24 every number is whole, a corner; a blend of these is that, infinite, or NaN.
    const float large = 3.4e38f, infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(picture_with({Vec2(large, -large), Vec2(-large, large), Vec2(large)}), expected);
    EXPECT_EQ(picture_with({Vec2(infinity), Vec2(-infinity), Vec2(infinity, large)}), expected);
    EXPECT_EQ(picture_with({Vec2(nan), Vec2(nan, 0), Vec2(0, nan)}), expected);
}

TEST(DispatchPlan, F07_TilesCoverTheFrameOnceWhateverTheirSize) {
    for (const double ms_per_pixel : {1e-7, 1e-4, 0.01, 3.0, 500.0}) {
        DispatchPlan plan(100);
        std::vector<int> seen(70 * 31);
        std::int64_t done = 0;
        while (done < 70 * 31) {
            const Tile t = plan.next(done, 70, 31);
            ASSERT_TRUE(t.x0 < t.x1 && t.x1 <= 70 && t.y0 < t.y1 && t.y1 <= 31);
            for (int y = t.y0; y < t.y1; ++y)
                for (int x = t.x0; x < t.x1; ++x) ++seen[std::size_t(y * 70 + x)];
            const std::int64_t pixels = std::int64_t(t.x1 - t.x0) * (t.y1 - t.y0);
            plan.learn(ms_per_pixel * double(pixels), t);
            done += pixels;
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 70 * 31) << ms_per_pixel;
    }
}

TEST(DispatchPlan, F07_AfterTheFirstNoTileTakesLongerThanAsked) {
    for (const double ms_per_pixel : {1e-6, 1e-3, 0.05, 1.0, 50.0}) {
        DispatchPlan plan(100);
        std::int64_t done = 0;
        for (int tile = 0; done < 2000 * 1000 && tile < 300; ++tile) {
            const Tile t = plan.next(done, 2000, 1000);
            const std::int64_t pixels = std::int64_t(t.x1 - t.x0) * (t.y1 - t.y0);
            if (tile > 0) {
                EXPECT_LE(ms_per_pixel * double(pixels), 100.0 + 1e-6);
            } else {
                EXPECT_LE(pixels, std::int64_t(DispatchPlan::first_pixels));
            }
            plan.learn(ms_per_pixel * double(pixels), t);
            done += pixels;
        }
    }
}

TEST(DispatchPlan, F07_AFastMachineSoonGetsTheWholeFrame) {
    DispatchPlan plan(100);
    std::int64_t done = 0;
    int tiles = 0;
    for (; done < 1000 * 1000; ++tiles) {
        const Tile t = plan.next(done, 1000, 1000);
        const std::int64_t pixels = std::int64_t(t.x1 - t.x0) * (t.y1 - t.y0);
        plan.learn(1e-6 * double(pixels), t);
        done += pixels;
    }
    EXPECT_LE(tiles, 10);
    EXPECT_EQ(plan.next(0, 1000, 1000).y1, 1000);
    plan.reset();
    EXPECT_EQ(plan.next(0, 1000, 1000).y1, 1);
}

}  // namespace
}  // namespace kd
