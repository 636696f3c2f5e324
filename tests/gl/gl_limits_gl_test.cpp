// Limits and their messages. Needs no context.
#include "renderer/gl/gl_limits.h"

#include <gtest/gtest.h>

#include "renderer/gl/pass_programs.h"
#include "tests/support/refusal.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

using test::refusal;

constexpr GlLimits small{1000, 64};

TEST(GlLimits, CountWhatAnUploadTakes) {
    const FlatScene scene = test::mirror_scene(10, 1);
    const KdTree tree;
    const UploadSizes sizes = upload_sizes(scene, tree);
    EXPECT_EQ(sizes.nodes, 1);
    EXPECT_EQ(sizes.references, 0);
    EXPECT_EQ(sizes.triangles, std::int64_t(scene.triangles.size()));
    EXPECT_EQ(sizes.texels, 5 * 3);
    EXPECT_EQ(sizes.table_texels, 5 * 3 + 4 * 2 + 1);
}

TEST(GlLimits, LetThroughWhatJustFits) {
    EXPECT_EQ(
        refusal([] { check_upload({.nodes = 1000, .references = 1000, .triangles = 333, .texels = 1000}, small); }),
        "accepted");
}

TEST(GlLimits, RefuseWithTheNumbers) {
    EXPECT_EQ(
        refusal([] { check_upload({.triangles = 334}, small); }),
        "scene on OpenGL: the triangles take 1002 texels, a texture buffer holds 1000 here; use a smaller scene or "
        "--tracer cpu");
    EXPECT_NE(refusal([] { check_upload({.nodes = 1001}, small); }).find("nodes take 1001 texels"), std::string::npos);
    EXPECT_NE(refusal([] { check_upload({.references = 1001}, small); }).find("1001 texels"), std::string::npos);
    EXPECT_NE(refusal([] { check_upload({.texels = 1001}, small); }).find("images take 1001"), std::string::npos);
}

TEST(GlLimits, RefuseNumbersThatFloatsCannotHold) {
    static constexpr GlLimits large{std::int64_t(1) << 40, 64};
    constexpr std::int64_t limit = std::int64_t(1) << 24;
    const auto check = [](const UploadSizes& sizes, const TraceConfig& config) {
        return refusal([&] { check_config(sizes, config, large); });
    };
    EXPECT_EQ(check({.nodes = limit, .references = limit}, {}), "accepted");
    EXPECT_EQ(check({.nodes = limit + 1}, {}),
              "scene on OpenGL: 16777217 nodes do not fit the tree's float4 texels, which number things exactly up to "
              "16777216; use --nodes 8, larger leaves or --tracer cpu");
    EXPECT_NE(check({.references = limit + 1}, {}).find("16777217 leaf list entries"), std::string::npos);
    // Nodes of 8 bytes number more, but ropes are floats and backtrack needs parents.
    constexpr TraceConfig packed{.nodes = NodeEncoding::packed};
    constexpr std::int64_t most = (std::int64_t(1) << 30) - 1;
    EXPECT_EQ(check({.nodes = most, .references = most}, packed), "accepted");
    EXPECT_NE(check({.references = most + 1}, packed).find("1073741824 leaf list entries"), std::string::npos);
    EXPECT_NE(check({.nodes = most + 1}, packed).find("up to 1073741823"), std::string::npos);
    TraceConfig config = packed;
    config.traversal = Traversal::ropes;
    EXPECT_NE(check({.nodes = limit + 1}, config).find("float texels of ropes"), std::string::npos);
    config.traversal = Traversal::backtrack;
    EXPECT_NE(check({.nodes = limit + 1}, config).find("float4 texels"), std::string::npos);
    config = packed;
    config.forced = Feature::wide_nodes;
    EXPECT_NE(check({.nodes = limit + 1}, config).find("float4 texels"), std::string::npos);
}

TEST(GlLimits, DependOnTheConfiguration) {
    TraceConfig config;
    const UploadSizes sizes{.nodes = 600, .references = 400, .triangles = 300};
    EXPECT_EQ(refusal([&] { check_config(sizes, config, small); }), "accepted");
    config.leaf_lists = LeafLists::duplicated;
    EXPECT_NE(refusal([&] { check_config(sizes, config, small); }).find("copied leaf lists take 1200 texels"),
              std::string::npos);
    config = {.traversal = Traversal::backtrack};
    EXPECT_NE(refusal([&] { check_config(sizes, config, small); }).find("boxes of all nodes take 1200 texels"),
              std::string::npos);
}

TEST(GlLimits, AStorageBufferHoldsBytes) {
    static constexpr GlLimits storage{1 << 20, 64, 1000};
    const auto check = [](const UploadSizes& sizes, const TraceConfig& config) {
        return refusal([&] { check_config(sizes, config, storage); });
    };
    EXPECT_EQ(refusal([] { check_upload({.triangles = 20}, storage); }), "accepted");
    EXPECT_EQ(
        refusal([] { check_upload({.triangles = 21}, storage); }),
        "scene on OpenGL: the triangles take 1008 bytes, a storage buffer holds 1000 here; use a smaller scene or "
        "--tracer cpu");
    EXPECT_EQ(check({.nodes = 62, .references = 500}, {}), "accepted");
    EXPECT_NE(check({.nodes = 63}, {}).find("nodes take 1008 bytes"), std::string::npos);
    EXPECT_EQ(check({.nodes = 125}, {.nodes = NodeEncoding::packed}), "accepted");
    EXPECT_NE(check({.nodes = 126}, {.nodes = NodeEncoding::packed}).find("1008 bytes"), std::string::npos);
    EXPECT_NE(check({.references = 501}, {}).find("leaf lists take 1002 bytes"), std::string::npos);
    EXPECT_NE(check({.references = 251, .triangles = 70000}, {}).find("leaf lists take 1004 bytes"), std::string::npos);
    EXPECT_NE(check({.nodes = 32}, {.traversal = Traversal::backtrack}).find("all nodes take 1024 bytes"),
              std::string::npos);
}

TEST(GlLimits, BoundTheNaiveTraversalByTheLoopBudget) {
    const TraceConfig lit{.traversal = Traversal::naive};
    const TraceConfig unlit{.traversal = Traversal::naive, .shadows = false};
    const UploadSizes sizes{.triangles = 30001, .lights = 2};
    EXPECT_EQ(refusal([&] { check_config(sizes, unlit, small); }), "accepted");
    EXPECT_EQ(
        refusal([&] { check_config(sizes, lit, small); }),
        "traversal naive on OpenGL: 30001 triangles times 2 rays per shader call exceed 60000 loop steps; use another "
        "traversal, --tracer cpu or a smaller scene");
    EXPECT_EQ(refusal([&] { check_config({.triangles = 60000}, lit, small); }), "accepted");
    EXPECT_NE(refusal([&] { check_config({.triangles = 60001}, unlit, small); }), "accepted");
}

TEST(GlLimits, BoundTheImage) {
    EXPECT_EQ(refusal([] { check_image(64, 64, small); }), "accepted");
    EXPECT_EQ(refusal([] { check_image(65, 2, small); }),
              "image of 65x2 pixels: a texture holds 64x64 here; ask for a smaller one");
}

TEST(PassPrograms, LeaveOutWhatASceneDoesNotNeed) {
    ProgramSettings bare;
    bare.needs.counters = false;
    const ProgramKey key = program_key(Step::shade_prim, bare);
    for (const char* define : {"KD_COUNTERS", "KD_NORMALS", "KD_TEXTURES", "KD_SHADOWS", "KD_DUPLICATED"})
        EXPECT_EQ(key.defines.at(define), "0") << define;
    EXPECT_EQ(key.defines.at("KD_TRAVERSE"), "traverse_naive") << "without shadow rays nothing walks";
    EXPECT_EQ(key.defines.at("KD_STACK_SIZE"), "1");
    bare.needs.shadows = true;
    EXPECT_EQ(program_key(Step::shade_prim, bare).defines.at("KD_TRAVERSE"), "traverse_stack");
    EXPECT_EQ(program_key(Step::shade_prim, bare).defines.at("KD_STACK_SIZE"), "64");
    bare.trace.traversal = Traversal::restart;
    EXPECT_EQ(program_key(Step::shade_prim, bare).defines.at("KD_STACK_SIZE"), "1");
    EXPECT_EQ(program_key(Step::shade_prim, bare).defines.at("KD_LONG_TRAIL"), "1");
}

TEST(PassPrograms, ShareRtPrimAcrossShadingSettings) {
    ProgramSettings plain, rich;
    rich.needs.textures = rich.needs.normals = rich.needs.shadows = rich.needs.highlights = true;
    EXPECT_EQ(program_key(Step::rt_prim, plain), program_key(Step::rt_prim, rich));
    EXPECT_NE(program_key(Step::shade_prim, plain), program_key(Step::shade_prim, rich));
}

TEST(PassPrograms, DrawLaterQuadsBetweenTheDepthsOfRtPrim) {
    EXPECT_EQ(depth_rule(Step::rt_prim, EarlyZ::working).function, GLenum(GL_ALWAYS));
    for (const Step step : {Step::shade_prim, Step::rt_refl, Step::shade_refl}) {
        const DepthRule working = depth_rule(step, EarlyZ::working);
        EXPECT_EQ(working.function, GLenum(GL_GREATER));
        EXPECT_FALSE(working.write);
        const DepthRule published = depth_rule(step, EarlyZ::as_published);
        EXPECT_EQ(published.function, GLenum(GL_LEQUAL));
        EXPECT_STREQ(published.quad, "0.0");
    }
}

}  // namespace
}  // namespace kd
