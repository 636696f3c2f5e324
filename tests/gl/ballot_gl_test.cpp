// Lanes counted by the machine against lanes computed: on a software renderer, whose groups nothing else decides, they
// are the same integers.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "renderer/gl/ballots.h"
#include "renderer/measure/ballot_check.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;

constexpr Schedule loops[] = {Schedule::if_if, Schedule::while_while};

TEST(BallotCheck, WhatAMachineDoesWithoutRaysIsADifference) {
    // Two groups of two pixels: the first has rays of two and one steps at interior nodes, the second has none.
    const std::vector<std::uint32_t> two{2}, one{1};
    const PixelPhases walks{&two, &one, nullptr, nullptr};
    BallotLayer layer;
    layer.group_size = 2;
    layer.lanes = Image<LaneBallots>(4, 1);
    for (std::size_t i = 0; i < 4; ++i) layer.lanes.pixels[i].group = i < 2 ? 0 : 2;
    layer.lanes.pixels[0].led[0] = 2;
    layer.lanes.pixels[0].led_lanes[0] = 3;
    const auto compared = [&] {
        BallotReport report;
        compare_groups(layer, walks, Schedule::if_if, report, true);
        return report;
    };
    const BallotReport alike = compared();
    EXPECT_TRUE(alike.exact()) << alike.first_difference;
    EXPECT_EQ(alike.groups, 1) << "idle where nothing is to be done";
    EXPECT_TRUE(std::isnan(alike.measured_map.at(2, 0)));
    layer.lanes.pixels[3].led[1] = 1;
    layer.lanes.pixels[3].led_lanes[1] = 1;
    const BallotReport report = compared();
    EXPECT_FALSE(report.exact());
    EXPECT_EQ(report.groups, 2);
    EXPECT_EQ(report.differ, 1);
    EXPECT_TRUE(report.first_difference.starts_with("the group of pixel 2, 0: 1 iterations (0 at interior nodes) with "
                                                    "1 active lanes measured, 0 (0) with 0 computed"))
        << report.first_difference;
    EXPECT_EQ(report.measured_map.at(2, 0), 0.5f);
}

class BallotGl : public ContextTest {
  protected:
    void SetUp() override {
        ContextTest::SetUp();
        if (IsSkipped()) return;
        if (!context->is_software())
            GTEST_SKIP() << "HARDWARE: lanes may part and join as they like; kdscope stats --ballot";
        if (ballot_support(gl()).kind == BallotSupport::Kind::none) GTEST_SKIP() << "NO BALLOTS in this driver";
        tracer = std::make_unique<GlTracer>(*context);
    }
    void TearDown() override { tracer.reset(); }

    void load(const std::string& name) {
        scene = flatten(*make_procedural(name));
        tree = build_tree(scene.triangles, {});
        tracer->upload(scene, tree);
    }
    BallotReport check(const TraceConfig& config, Schedule loop, Pass rays, int width, int height) {
        return check_ballots(*tracer, {scene, tree, config, pinhole(scene.camera, width, height), width, height, rays},
                             loop);
    }
    void expect_exact(const TraceConfig& config, Pass rays, int width, int height) {
        for (const Schedule loop : loops) {
            const BallotReport report = check(config, loop, rays, width, height);
            EXPECT_TRUE(report.exact()) << info(config.traversal).name << " " << info(loop).name << " "
                                        << ray_names[std::size_t(rays)] << " " << width << "x" << height << ": "
                                        << report.differ << " of " << report.groups << " groups differ, "
                                        << report.unlike << " rays; " << report.first_difference;
            EXPECT_EQ(report.measured, report.computed);
            EXPECT_LT(report.measured.efficiency(report.group_size), 1.0) << "something must diverge";
        }
    }

    /// The test runs once as the renderer is, and with each of two widths that it is told (tests/CMakeLists.txt).
    static int expected_width() {
        const char* bits = std::getenv("LP_NATIVE_VECTOR_WIDTH");
        return bits ? std::atoi(bits) / 32 : 0;
    }

    FlatScene scene;
    KdTree tree;
    std::unique_ptr<GlTracer> tracer;
};
KD_FOR_ALL_CONTEXTS(BallotGl);

/// Every walk of the tree, short stacks that run empty and ropes that are not optimised among them.
std::vector<TraceConfig> every_walk() {
    std::vector<TraceConfig> walks{{.traversal = Traversal::short_stack, .short_stack = 1},
                                   {.traversal = Traversal::ropes, .optimised_ropes = false}};
    for (const TraversalInfo& traversal : traversals())
        if (traversal.id != Traversal::naive) walks.push_back({.traversal = traversal.id});
    return walks;
}

TEST_P(BallotGl, EveryTraversalOnEveryScene) {
    for (const char* name : {"ball:1000", "rooms", "scatter:300"}) {
        load(name);
        for (const TraceConfig& walk : every_walk()) expect_exact(walk, Pass::rt_prim, 64, 48);
    }
    expect_exact({.nodes = NodeEncoding::packed}, Pass::rt_prim, 64, 48);
}

TEST_P(BallotGl, ATracerOfComputeShadersCountsTheLanesOfFragments) {
    for (const GlMode mode : {GlMode::compute, GlMode::wavefront}) {
        tracer = std::make_unique<GlTracer>(*context, mode);
        load("ball:300");
        expect_exact({}, Pass::rt_prim, 32, 24);
    }
}

TEST_P(BallotGl, EveryKindOfRay) {
    load("cornell");
    for (const Pass rays : {Pass::shade_prim, Pass::rt_refl, Pass::shade_refl})
        for (const TraceConfig& walk : every_walk()) expect_exact(walk, rays, 64, 64);
}

TEST_P(BallotGl, WhatIsNotTheSameWalkIsFound) {
    load("ball:1000");
    const KdTree other = build_tree(scene.triangles, {.leaf_size = 16});
    tracer->upload(scene, other);
    for (const Schedule loop : loops) {
        const BallotReport report = check({}, loop, Pass::rt_prim, 64, 64);
        EXPECT_FALSE(report.exact());
        EXPECT_GT(report.differ, 0);
        EXPECT_FALSE(report.first_difference.empty());
        EXPECT_NE(report.measured, report.computed);
    }
}

TEST_P(BallotGl, TheBordersOfThePictureAreIdleLanes) {
    load("ball:1000");
    for (const auto& [width, height] : {std::pair(61, 37), std::pair(64, 37), std::pair(61, 40), std::pair(3, 5)})
        expect_exact({}, Pass::rt_prim, width, height);
}

TEST_P(BallotGl, TheShaderTellsTheShapeOfItsGroups) {
    load("ball:1000");
    const BallotReport report = check({}, Schedule::while_while, Pass::rt_prim, 64, 64);
    if (expected_width() > 0) {
        EXPECT_EQ(report.group_size, expected_width());
    }
    EXPECT_GE(report.group_size, 4);
    EXPECT_EQ(report.tile_width * report.tile_height, report.group_size) << "groups are tiles of pixels";
    EXPECT_EQ(report.groups, 64 * 64 / report.group_size);
    EXPECT_EQ(report.rays, 64 * 64);
    EXPECT_EQ(report.measured_map, report.computed_map);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int left = x / report.tile_width * report.tile_width,
                      top = y / report.tile_height * report.tile_height;
            EXPECT_GT(report.measured_map.at(x, y), 0.0f);
            ASSERT_EQ(report.measured_map.at(x, y), report.measured_map.at(left, top)) << "one value a group";
        }
    const auto [least, most] = std::ranges::minmax(report.measured_map.pixels);
    EXPECT_LT(least, most) << "groups differ from each other";
    RecordProperty("width", report.group_size);
}

TEST_P(BallotGl, TheTwoLoopsAreTwoMachines) {
    load("ball:1000");
    const BallotReport one = check({}, Schedule::if_if, Pass::rt_prim, 64, 64);
    const BallotReport two = check({}, Schedule::while_while, Pass::rt_prim, 64, 64);
    EXPECT_EQ(one.measured.steps, two.measured.steps) << "the same walks";
    EXPECT_NE(one.measured.iterations, two.measured.iterations) << "or the test could not tell them apart";
}

TEST_P(BallotGl, RefusesWhatHasNoLoop) {
    load("ball:1000");
    const auto message = [&](const TraceConfig& config, Schedule loop) -> std::string {
        try {
            (void)check(config, loop, Pass::rt_prim, 8, 8);
        } catch (const BallotError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message({.traversal = Traversal::naive}, Schedule::if_if).find("naive"), std::string::npos);
    EXPECT_NE(message({.rules = Rules::as_published}, Schedule::if_if).find("as-published"), std::string::npos);
    EXPECT_NE(message({}, Schedule::lockstep).find("if-if or while-while"), std::string::npos);
}

}  // namespace
}  // namespace kd
