// When a list of a tile's pixels is made, and that no picture hangs on it.
#include "renderer/gl/list_fill.h"

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"
#include "tests/support/environment_variable.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;
using test::whole;

constexpr int height = 128;
constexpr Tile upper{0, 0, 64, 64}, lower{0, 64, 64, 128};

TEST(ListFill, FullListsAreLeftOutForSomeFrames) {
    ListFill fill;
    for (int times = 0; times < 2; ++times) {
        ASSERT_TRUE(fill.asks_for_list(upper, height));
        EXPECT_FALSE(fill.keeps_list(upper, height, 0.95));
        for (int i = 0; i < ListFill::tiles_between_looks; ++i) EXPECT_FALSE(fill.asks_for_list(upper, height)) << i;
    }
    EXPECT_TRUE(fill.asks_for_list(upper, height)) << "a look now and then";
}

TEST(ListFill, ListsWithGapsAreMadeEachTime) {
    ListFill fill;
    for (int times = 0; times < 3; ++times) {
        EXPECT_TRUE(fill.asks_for_list(upper, height));
        EXPECT_TRUE(fill.keeps_list(upper, height, ListFill::full_enough));
    }
}

TEST(ListFill, RowsAreRememberedHoweverAFrameIsCut) {
    ListFill fill;
    EXPECT_FALSE(fill.keeps_list(upper, height, 1.0));
    EXPECT_FALSE(fill.asks_for_list({0, 8, 64, 40}, height)) << "within rows that are full";
    EXPECT_FALSE(fill.asks_for_list({32, 63, 64, 64}, height));
    EXPECT_TRUE(fill.asks_for_list({0, 32, 64, 65}, height)) << "nothing is known of its last row";
    EXPECT_TRUE(fill.asks_for_list(lower, height));
    EXPECT_TRUE(fill.keeps_list(lower, height, 0.5));
    EXPECT_TRUE(fill.asks_for_list({0, 0, 64, 128}, height));
    EXPECT_FALSE(fill.keeps_list({0, 0, 64, 128}, height, 1.0));
    EXPECT_FALSE(fill.asks_for_list(lower, height));
}

/// What is compiled for.
TEST(ListFill, AnEmptyTileSaysNothing) {
    ListFill fill;
    EXPECT_FALSE(fill.keeps_list(Tile{}, height, 1.0));
    EXPECT_TRUE(fill.asks_for_list(Tile{}, height));
    EXPECT_TRUE(fill.asks_for_list(upper, height));
    EXPECT_FALSE(fill.keeps_list(upper, height, 1.0));
    EXPECT_TRUE(fill.keeps_list(Tile{}, height, 0.0));
    EXPECT_FALSE(fill.asks_for_list(upper, height)) << "nor does it make forget";
}

using ListFillGl = ContextTest;
KD_FOR_ALL_CONTEXTS(ListFillGl);

/// Every lane has a hit, so that the second frame lists its reflections out of no list.
TEST_P(ListFillGl, FramesAreAlikeWithAListAndWithout) {
    constexpr int side = 32;
    const test::Variable variable("KDSCOPE_COMPUTE", "8x8,lists");
    const FlatScene scene = test::mirror_scene(80, 5);
    const KdTree tree = build_tree(scene.triangles, {});
    Camera close = scene.camera;
    close.fov_y_degrees = 5;
    const PinholeCamera camera = pinhole(close, side, side);
    GlTraceConfig config;
    config.trace.reflection_depth = 3;
    Frame expected(side, side);
    CpuTracer(scene, tree).trace_frame(config.trace, camera, expected, 2);
    EXPECT_EQ(std::ranges::count(expected.layers[0].hit.pixels, -1, &Hit::triangle), 0);
    EXPECT_LT(std::ranges::count(expected.layers[2].hit.pixels, -1, &Hit::triangle), side * side) << "reflections hit";
    GlTracer tracer(*context, GlMode::compute);
    tracer.upload(scene, tree);
    for (int drawn = 0; drawn < 3; ++drawn) {
        (void)tracer.draw(config, camera, side, side, whole(side, side));
        const Frame frame = tracer.read_frame(config.trace);
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            EXPECT_TRUE(std::ranges::equal(frame.layers[pass].hit.pixels, expected.layers[pass].hit.pixels, bit_equal))
                << drawn << " " << pass;
    }
}

}  // namespace
}  // namespace kd
