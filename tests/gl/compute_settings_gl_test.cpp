// What may be said about compute shaders, and that no answer hangs on it.
#include "renderer/gl/compute_settings.h"

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/multiprocessors.h"
#include "renderer/gl/program.h"
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

TEST(ComputeSettings, SayHowGroupsAreShaped) {
    EXPECT_EQ(parse_compute_settings("16x8"), (ComputeSettings{.x = 16, .y = 8, .morton = true}));
    EXPECT_EQ(parse_compute_settings("32x8"), (ComputeSettings{.x = 32, .y = 8, .morton = false}));
    EXPECT_EQ(parse_compute_settings("8x8,linear,textures"),
              (ComputeSettings{.x = 8, .y = 8, .morton = false, .storage = false}));
    EXPECT_EQ(parse_compute_settings("8x4,storage").storage, true);
    EXPECT_EQ(parse_compute_settings("8x4,lists").lists, true);
    EXPECT_EQ(parse_compute_settings("8x4,no-lists").lists, false);
    EXPECT_EQ(parse_compute_settings("8x8,dealt").dealt, true);
    EXPECT_EQ(parse_compute_settings("8x8,in-order").dealt, false);
}

TEST(ComputeSettings, RefuseWhatIsNone) {
    const auto told = [](const char* text) { return refusal([&] { (void)parse_compute_settings(text); }); };
    constexpr const char* remedy =
        "; say 16x8, or with linear, storage or textures, lists or no-lists, dealt or in-order behind it: 8x4,storage";
    EXPECT_EQ(told("8"), std::string("KDSCOPE_COMPUTE '8': it begins with no size") + remedy);
    EXPECT_EQ(told("0x8"), std::string("KDSCOPE_COMPUTE '0x8': '0' is no number from 1 to 1024") + remedy);
    EXPECT_EQ(told("64x32"), std::string("KDSCOPE_COMPUTE '64x32': a group has at most 1024 pixels") + remedy);
    EXPECT_EQ(
        told("8x8,storage,linear,textures"),
        std::string("KDSCOPE_COMPUTE '8x8,storage,linear,textures': 'storage' and 'textures' exclude each other") +
            remedy);
    EXPECT_EQ(told("8x8,fast"), std::string("KDSCOPE_COMPUTE '8x8,fast': 'fast' is unknown") + remedy);
}

using ComputeGl = ContextTest;
KD_FOR_ALL_CONTEXTS(ComputeGl);

TEST_P(ComputeGl, NoSettingChangesAFrame) {
    constexpr int width = 41, height = 35;  // no multiple of a group
    const FlatScene scene = test::mirror_scene(200, 7);
    const KdTree tree = build_tree(scene.triangles, {});
    const PinholeCamera camera = pinhole(scene.camera, width, height);
    GlTraceConfig config;
    config.trace.reflection_depth = 4;  // a third bounce finds what the first has left
    Frame expected(width, height);
    CpuTracer(scene, tree).trace_frame(config.trace, camera, expected, 2);
    for (const char* said : {"8x8", "16x8,storage,no-lists,dealt", "32x2,linear,textures", "8x1,storage,lists,dealt",
                             "64x16,lists", "8x8,no-lists", "8x8,lists,in-order"}) {
        const test::Variable variable("KDSCOPE_COMPUTE", said);
        GlTracer tracer(*context, GlMode::compute);
        tracer.upload(scene, tree);
        (void)tracer.draw(config, camera, width, height, whole(width, height));
        const Frame frame = tracer.read_frame(config.trace);
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            const RayLayer &found = frame.layers[pass], &wanted = expected.layers[pass];
            EXPECT_TRUE(std::ranges::equal(found.hit.pixels, wanted.hit.pixels, bit_equal)) << said << " " << pass;
            EXPECT_TRUE(std::ranges::equal(found.counters.pixels, wanted.counters.pixels)) << said << " " << pass;
        }
    }
}

TEST_P(ComputeGl, ShadesThePixelsThatEarlyZLeaves) {
    constexpr int width = 50, height = 35;  // no multiple of a group
    const FlatScene scene = test::mirror_scene(80, 5);
    const KdTree tree = build_tree(scene.triangles, {});
    GlTraceConfig config;
    config.count_shaded = true;
    config.trace.reflection_depth = 4;
    const auto shaded = [&](GlMode mode, const char* said) {
        const test::Variable variable("KDSCOPE_COMPUTE", said);
        GlTracer tracer(*context, mode);
        tracer.upload(scene, tree);
        // In two tiles: the second begins inside a group, and finds the list that the first has left.
        const PinholeCamera camera = pinhole(scene.camera, width, height);
        std::array<std::int64_t, pass_count> sum{};
        for (const Tile tile : {Tile{0, 0, width, 13}, Tile{0, 13, width, height}}) {
            const GlFrameReport report = tracer.draw(config, camera, width, height, tile);
            for (std::size_t pass = 0; pass < pass_count; ++pass) sum[pass] += report.shaded_pixels[pass];
        }
        return sum;
    };
    const auto culled = shaded(GlMode::fragment, "8x8");
    // Where pixels are listed all that run are counted, else those that have work.
    EXPECT_EQ(shaded(GlMode::compute, "8x8,lists"), culled);
    EXPECT_EQ(shaded(GlMode::compute, "32x2,lists"), culled);
    EXPECT_EQ(shaded(GlMode::compute, "8x8,no-lists"), culled);
    EXPECT_GT(culled[2], 0);
    EXPECT_LT(culled[2], 4 * culled[1]);  // of four bounces
    EXPECT_LT(culled[1], width * height);
}

TEST_P(ComputeGl, CountsMultiprocessorsWhereTheDriverTells) {
    for (const GlMode mode : gl_modes) {
        const std::optional<Multiprocessors> counted = multiprocessors_used(gl(), mode, 256, 256);
        EXPECT_EQ(counted.has_value(), ballot_support(gl()).multiprocessors);
        if (!counted) continue;
        EXPECT_GE(counted->used, 1);
        EXPECT_LE(counted->used, counted->there);
    }
}

/// The shaders of multiprocessors_used(), as a driver with the extension reads them: what it adds is 0 here.
TEST_P(ComputeGl, ShadersThatTellTheirMultiprocessorCompile) {
    const ShaderReader read = [](const std::string& path) {
        std::optional<std::string> text = default_shader_reader()(path);
        for (const auto& [from, to] : {std::pair{"#extension GL_NV_shader_thread_group : require", ""},
                                       std::pair{"gl_SMIDNV", "0u"}, std::pair{"gl_SMCountNV", "0u"}})
            if (const std::size_t at = text ? text->find(from) : std::string::npos; at != std::string::npos)
                text->replace(at, std::string_view(from).size(), to);
        return text;
    };
    ProgramKey computed;
    computed.compute = "compute/multiprocessors.comp";
    computed.defines = {{"KD_GROUP_X", "8"}, {"KD_GROUP_Y", "8"}};
    EXPECT_NO_THROW(GlProgram(gl(), computed, read));
    EXPECT_NO_THROW(
        GlProgram(gl(), {"fragment/quad.vert", "fragment/multiprocessors.frag", {{"KD_QUAD_DEPTH", "0.0"}}}, read));
}

}  // namespace
}  // namespace kd
