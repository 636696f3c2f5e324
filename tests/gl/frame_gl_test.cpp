// Targets, tiles, uploads and reports of the tracer.
#include "renderer/geometry/input_error.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::MachineTest;
using test::whole;

class FrameGl : public MachineTest {
  protected:
    void SetUp() override {
        MachineTest::SetUp();
        if (!context) return;
        scene = test::mirror_scene(80, 5);
        tree = build_tree(scene.triangles, {});
        tracer = std::make_unique<GlTracer>(*context, mode());
        tracer->upload(scene, tree);
    }
    void TearDown() override { tracer.reset(); }

    GlFrameReport draw(int width, int height, Tile tile) {
        return tracer->draw(config, pinhole(scene.camera, width, height), width, height, tile);
    }
    Frame draw_whole(int width, int height) {
        (void)draw(width, height, whole(width, height));
        return tracer->read_frame(config.trace);
    }

    FlatScene scene;
    KdTree tree;
    std::unique_ptr<GlTracer> tracer;
    GlTraceConfig config;
};
KD_FOR_ALL_MACHINES(FrameGl);

void expect_same(const Frame& a, const Frame& b) {
    EXPECT_EQ(a.colour, b.colour);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        EXPECT_TRUE(std::ranges::equal(a.layers[pass].hit.pixels, b.layers[pass].hit.pixels, bit_equal)) << pass;
        EXPECT_TRUE(std::ranges::equal(a.layers[pass].counters.pixels, b.layers[pass].counters.pixels,
                                       [](const RayCounters& x, const RayCounters& y) { return x == y; }))
            << pass;
    }
}

TEST_P(FrameGl, TilesMakeTheWholeFrame) {
    for (const int depth : {1, 3}) {
        config.trace.reflection_depth = depth;
        const Frame expected = draw_whole(70, 50);
        (void)draw_whole(8, 8);  // new targets
        for (const Tile& tile : tiles_of(70, 50, 16)) (void)draw(70, 50, tile);
        expect_same(tracer->read_frame(config.trace), expected);
    }
}

TEST_P(FrameGl, PixelsOutsideTheTileStayUntraced) {
    config.trace.sampling.sample = 0;  // all passes
    (void)draw(40, 30, {10, 5, 20, 15});
    const Frame frame = tracer->read_frame(config.trace);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 10 && x < 20 && y >= 5 && y < 15;
            ASSERT_EQ(frame.colour.at(x, y).w, inside ? 1.0f : 0.0f) << x << "," << y;
            if (inside) continue;
            for (const RayLayer& layer : frame.layers) {
                ASSERT_TRUE(bit_equal(layer.hit.at(x, y), Hit{-1, 0, 0, 0}));
                ASSERT_TRUE(layer.counters.at(x, y) == RayCounters{});
            }
        }
}

TEST_P(FrameGl, DrawingOverAFrameLeavesNothingOfIt) {
    config.trace.sampling.sample = 0;  // all passes
    // The mirror fills the first picture and is absent from the second.
    const Camera sideways = scene.camera;
    scene.camera = {Vec3(0.5f, 4.0f, 0.5f), Vec3(0.5f, 0.0f, 0.5f), Vec3(0, 0, 1), 20.0f};
    (void)draw_whole(32, 32);
    scene.camera = {Vec3(0.5f, 4.0f, 0.5f), Vec3(0.5f, 9.0f, 0.5f), Vec3(0, 0, 1), 20.0f};
    const Frame sky = draw_whole(32, 32);
    scene.camera = sideways;
    for (std::size_t i = 0; i < sky.colour.pixels.size(); ++i) {
        ASSERT_EQ(sky.colour.pixels[i], Vec4(scene.background, 1.0f));
        for (const RayLayer& layer : sky.layers) ASSERT_EQ(layer.hit.pixels[i].triangle, -1);
        for (int pass = 1; pass < pass_count; ++pass)
            ASSERT_TRUE(sky.layer(Pass(pass)).counters.pixels[i] == RayCounters{});
    }
}

TEST_P(FrameGl, SurvivesEverySize) {
    const std::pair<int, int> sizes[] = {{1, 1}, {3, 200}, {257, 2}, {0, 0}, {0, 5}, {64, 64}, {63, 65}};
    for (const auto& [width, height] : sizes) {
        if (width == 0) {
            EXPECT_EQ(tracer->draw(config, PinholeCamera{}, width, height, whole(width, height)).total_ms, 0.0);
            continue;
        }
        (void)draw(width, height, whole(width, height));
        const Frame frame = tracer->read_frame(config.trace);
        ASSERT_EQ(frame.width, width);
        ASSERT_EQ(frame.height, height);
        for (const Vec4& c : frame.colour.pixels) ASSERT_EQ(c.w, 1.0f);
    }
}

TEST_P(FrameGl, RefusesAnImageBeyondTheTextureSize) {
    GLint largest = 0;
    gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    EXPECT_THROW((void)draw(largest + 1, 1, whole(1, 1)), InputError);
    EXPECT_EQ(draw_whole(16, 16).colour.at(8, 8).w, 1.0f);
}

TEST_P(FrameGl, WithoutCountersOnlyTheCountersGo) {
    config.trace.sampling.sample = 0;  // all passes
    const Frame counted = draw_whole(48, 32);
    config.trace.counters = false;
    Frame plain = draw_whole(48, 32);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        for (const RayCounters& c : plain.layers[pass].counters.pixels) ASSERT_TRUE(c == RayCounters{});
        plain.layers[pass].counters = counted.layers[pass].counters;
    }
    expect_same(plain, counted);
}

TEST_P(FrameGl, PrepareDrawsNothing) {
    const Frame before = draw_whole(32, 24);
    tracer->prepare(config, 32, 24);
    expect_same(tracer->read_frame(config.trace), before);
}

TEST_P(FrameGl, NamesItsClock) {
    config.trace.sampling.sample = 0;  // all passes
    const GlFrameReport report = draw(32, 24, whole(32, 24));
    EXPECT_EQ(report.clock, context->is_software() ? "finish + steady clock" : "timer query");
    double sum = 0;
    for (const double ms : report.pass_ms) {
        EXPECT_GT(ms, 0.0);
        sum += ms;
    }
    EXPECT_LE(sum, report.total_ms * 1.001 + 0.01);
}

TEST_P(FrameGl, LeavesTheStateOfOthersAlone) {
    gl().Viewport(1, 2, 3, 4);
    gl().Enable(GL_BLEND);
    gl().Disable(GL_DEPTH_TEST);
    (void)draw_whole(16, 16);
    GLint viewport[4], framebuffer = -1, program = -1;
    gl().GetIntegerv(GL_VIEWPORT, viewport);
    gl().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    gl().GetIntegerv(GL_CURRENT_PROGRAM, &program);
    EXPECT_TRUE(std::ranges::equal(viewport, std::array{1, 2, 3, 4}));
    EXPECT_EQ(framebuffer, 0);
    EXPECT_EQ(program, 0);
    EXPECT_TRUE(gl().IsEnabled(GL_BLEND));
    EXPECT_FALSE(gl().IsEnabled(GL_DEPTH_TEST));
    EXPECT_FALSE(gl().IsEnabled(GL_SCISSOR_TEST));
}

TEST_P(FrameGl, MemoryIsWhatTheTablesTake) {
    (void)draw_whole(32, 16);
    const auto n = std::int64_t(scene.triangles.size());
    GlMemory memory = tracer->memory();
    EXPECT_EQ(memory.nodes, 16 * std::int64_t(tree.nodes.size()));
    EXPECT_EQ(memory.references, 2 * std::int64_t(tree.references.size()));
    EXPECT_EQ(memory.triangles, 48 * n);
    EXPECT_EQ(memory.boxes, 0) << "no traversal has asked for them";
    EXPECT_EQ(memory.textures, 4 * 15);
    // colour, depth, four layers of hit and two counter texels, and a path's direction and weight
    EXPECT_EQ(memory.targets, 32 * 16 * (16 + 4 + 4 * 48 + 32));
    config.trace.traversal = Traversal::backtrack;
    config.trace.leaf_lists = LeafLists::duplicated;
    (void)draw_whole(32, 16);
    memory = tracer->memory();
    EXPECT_EQ(memory.boxes, 32 * std::int64_t(tree.nodes.size()));
    EXPECT_EQ(memory.triangles, 48 * n + 48 * std::int64_t(tree.references.size()));
}

TEST_P(FrameGl, LeavesOutAttributesThatAreNotNeeded) {
    FlatScene plain = test::scene_of(test::random_soup(20, 0.2f, 1));
    const KdTree plain_tree = build_tree(plain.triangles, {});
    tracer->upload(plain, plain_tree);
    (void)draw_whole(8, 8);
    const GlMemory memory = tracer->memory();
    EXPECT_EQ(memory.attributes, 16 * (5 + 4)) << "one material needs no numbers";
    EXPECT_EQ(memory.textures, 0);
    tracer->upload(scene, tree);
}

TEST_P(FrameGl, ATreeThatItsNodesCannotHoldLeavesTheTracerUsable) {
    const Frame before = draw_whole(24, 24);
    KdTree wrong;
    wrong.nodes[0].link = (1 << 24) + 2;  // beyond what a float texel holds exactly
    tracer->upload(scene, wrong);
    EXPECT_THROW(tracer->prepare(config, 24, 24), InputError);
    tracer->upload(scene, tree);
    expect_same(draw_whole(24, 24), before);
}

TEST_P(FrameGl, RefusesNaiveBeyondTheLoopBudget) {
    const FlatScene large = test::scene_of(test::random_soup(60001, 0.01f, 1));
    KdTree leaf;
    leaf.nodes[0].count = 60001;
    for (int i = 0; i < 60001; ++i) leaf.references.push_back(i);
    leaf.bounds = large.bounds;
    tracer->upload(large, leaf);
    config.trace.traversal = Traversal::naive;
    try {
        (void)draw(8, 8, whole(8, 8));
        FAIL();
    } catch (const InputError& error) {
        const char* why = mode() == GlMode::wavefront ? "has no naive" : "60001 triangles";
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
    // A leaf of that size is beyond the budget too, and is told pixel by pixel.
    config.trace.traversal = Traversal::stack;
    scene.camera = large.camera;
    const Frame frame = draw_whole(8, 8);
    for (int y = 3; y < 5; ++y)
        for (int x = 3; x < 5; ++x)
            EXPECT_EQ(frame.layer(Pass::rt_prim).counters.at(x, y).exit_reason, uint(KD_EXIT_STEP_CAP));
    tracer->upload(scene, tree);
}

TEST_P(FrameGl, NothingUploadedIsAnError) {
    GlTracer fresh(*context, mode());
    EXPECT_THROW((void)fresh.draw(config, PinholeCamera{}, 4, 4, whole(4, 4)), GlError);
    EXPECT_TRUE(fresh.read_frame(config.trace).colour.empty());
}

}  // namespace
}  // namespace kd
