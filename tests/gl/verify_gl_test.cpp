// renderer/measure: timing, ray sets, ray counts, and verify() on CPU and OpenGL.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/compare.h"
#include "renderer/measure/pixel_rays.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/verify.h"
#include "renderer/trace/counters.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

TEST(PixelRays, OnePerPixelFromTheTop) {
    const PinholeCamera camera = pinhole(Camera{}, 4, 2);
    const std::vector<Ray> rays = pixel_rays(camera, 4, 2);
    ASSERT_EQ(rays.size(), 8u);
    EXPECT_GT(rays[0].direction.y, 0);
    EXPECT_LT(rays[7].direction.y, 0);
    EXPECT_LT(rays[0].direction.x, 0);
    EXPECT_EQ(rays[0].direction.x, -rays[3].direction.x);
}

TEST(PixelRays, StratifiedRaysArePixelRaysOfTheirCell) {
    const PinholeCamera camera = pinhole(Camera{}, 40, 40);
    const std::vector<Ray> all = pixel_rays(camera, 40, 40);
    const std::vector<Ray> some = stratified_pixel_rays(camera, 40, 40, 110, 3);
    ASSERT_EQ(some.size(), 100u);
    for (std::size_t i = 0; i < some.size(); ++i) {
        const auto found = std::ranges::find_if(all, [&](const Ray& r) { return r.direction == some[i].direction; });
        ASSERT_NE(found, all.end());
        const auto pixel = std::size_t(found - all.begin());
        EXPECT_EQ(pixel / 40 / 4, i / 10);
        EXPECT_EQ(pixel % 40 / 4, i % 10);
    }
}

TEST(AdversarialRays, AreTheSameForASeed) {
    const FlatScene scene = test::scene_of(test::voxel_city(3));
    const KdTree tree = build_tree(scene.triangles, {});
    const auto text = [&](unsigned seed) {
        std::string all;
        for (const Ray& ray : adversarial_rays(scene, tree, 500, seed)) all += exact_text(ray) + "\n";
        return all;
    };
    EXPECT_EQ(text(1), text(1));
    EXPECT_NE(text(1), text(2));
}

TEST(AdversarialRays, HoldWhatBreaksTraversals) {
    const FlatScene scene = test::scene_of(test::voxel_city(3));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = adversarial_rays(scene, tree, 3000, 1);
    ASSERT_EQ(rays.size(), 3000u);
    const auto count = [&](auto is) { return std::ranges::count_if(rays, is); };
    const auto zero = [](float x, bool negative) { return x == 0.0f && std::signbit(x) == negative; };
    EXPECT_GT(count([&](const Ray& r) { return zero(r.direction.x, true); }), 100);
    EXPECT_GT(count([&](const Ray& r) { return zero(r.direction.x, false); }), 100);
    EXPECT_GT(count([&](const Ray& r) {  // starts on a split plane
                  return std::ranges::any_of(
                      tree.nodes, [&](const TreeNode& n) { return !n.is_leaf() && r.origin[n.flag] == n.split; });
              }),
              300);
    EXPECT_GT(count([](const Ray& r) { return std::isnan(r.origin.x + r.direction.x + r.t_min); }), 10);
    EXPECT_GT(count([](const Ray& r) { return std::abs(r.origin.x) > 1000; }), 50);
    EXPECT_GT(count([](const Ray& r) { return r.source >= 0; }), 50);
}

TEST(AdversarialRays, ExistForTheEmptyScene) {
    const FlatScene scene = test::scene_of({});
    EXPECT_EQ(adversarial_rays(scene, KdTree{}, 100, 1).size(), 100u);
}

TEST(RayCount, EqualsWhatTheFrameShows) {
    const FlatScene scene = test::mirror_scene(300, 5);
    const KdTree tree = build_tree(scene.triangles, {});
    const PinholeCamera camera = pinhole(scene.camera, 48, 40);
    TraceConfig config;
    Frame frame(48, 40);
    CpuTracer(scene, tree).trace_frame(config, camera, frame);
    const RayCounts rays = count_rays(scene, tree, config, camera, 48, 40);
    EXPECT_EQ(rays[0], 48 * 40);
    // A mirror ray starts inside of the bounds and so visits a leaf.
    const auto& mirrored = frame.layer(Pass::rt_refl).counters.pixels;
    EXPECT_EQ(rays[2], std::ranges::count_if(mirrored, [](const RayCounters& c) { return c.leaves > 0; }));
    EXPECT_GT(rays[2], 0);
    EXPECT_GT(rays[1], 0);
    EXPECT_LE(rays[1], std::int64_t(scene.lights.size()) * 48 * 40);

    config.shadows = false;
    config.reflection_depth = 0;
    EXPECT_EQ(count_rays(scene, tree, config, camera, 48, 40), (RayCounts{48 * 40}));
}

TEST(RayCount, EndsWhenStopped) {
    const FlatScene scene = test::mirror_scene(300, 5);
    const KdTree tree = build_tree(scene.triangles, {});
    std::stop_source stop;
    stop.request_stop();
    const PinholeCamera camera = pinhole(scene.camera, 48, 40);
    EXPECT_EQ(count_rays(scene, tree, {}, camera, 48, 40, stop.get_token()), RayCounts{});
}

ReferenceRays one_ray(Hit expected) { return {{Ray{Vec3(0), Vec3(0, 0, 1), 0.0f, 10.0f, -1}}, {expected}}; }

VerifyRow compared(Hit expected, Hit found, int any_triangle, int exponent = 0) {
    FlatScene scene;
    scene.exponent = exponent;
    RayAnswers answers(1);
    answers.nearest[0] = found;
    answers.any[0].triangle = any_triangle;
    VerifyRow row;
    compare_hits(scene, one_ray(expected), answers, row);
    return row;
}

TEST(Compare, EveryBitCounts) {
    const Hit hit{4, 2.0f, 0.25f, 0.5f};
    EXPECT_EQ(compared(hit, hit, 9).mismatches, 0);
    EXPECT_EQ(compared(hit, {4, std::nextafter(2.0f, 3.0f), 0.25f, 0.5f}, 9).mismatches, 1);
    EXPECT_EQ(compared(hit, {4, 2.0f, 0.25f, std::nextafter(0.5f, 1.0f)}, 9).mismatches, 1);
    EXPECT_EQ(compared(hit, {-1, 10.0f, 0, 0}, 9).mismatches, 1);
    EXPECT_EQ(compared({-1, 10.0f, 0, 0}, {-1, 10.0f, 0, 0}, -1).mismatches, 0);
    // Nearest agrees, but the any-hit walk saw nothing.
    EXPECT_EQ(compared(hit, hit, -1).mismatches, 1);
    const VerifyRow tie = compared(hit, {5, 2.0f, 0.1f, 0.1f}, 9);
    EXPECT_EQ(tie.mismatches, 0);
    EXPECT_EQ(tie.ties, 1);
}

TEST(Compare, FailureTextIsExact) {
    const VerifyRow row = compared({4, 2.5f, 0.25f, 0.5f}, {-1, 10.0f, 0, 0}, -1);
    EXPECT_EQ(row.first_failure, "ray 0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x1p+0,0x0p+0,0x1.4p+3: expected triangle "
                                 "4 t 0x1.4p+1 u 0x1p-2 v 0x1p-1; found no hit");
}

TEST(Compare, FailureTextIsInSceneUnits) {
    const VerifyRow row = compared({4, 2.5f, 0.25f, 0.5f}, {-1, 10.0f, 0, 0}, -1, 20);
    EXPECT_EQ(row.first_failure, "ray 0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x1p+0,0x0p+0,0x1.4p+23: expected triangle "
                                 "4 t 0x1.4p+21 u 0x1p-2 v 0x1p-1; found no hit");
}

TEST(Compare, CountersThatDifferAreFound) {
    RayAnswers cpu(1), gl(1);
    cpu.counters[0].leaves = 3;
    gl.counters[0].leaves = 4;
    VerifyRow row;
    row.tracer = "gl-fragment";
    compare_counters({}, one_ray({-1, 10.0f, 0, 0}), cpu, gl, row);
    EXPECT_EQ(row.counter_mismatches, 1);
    EXPECT_NE(row.first_failure.find("leaves 3"), std::string::npos);
    EXPECT_NE(row.first_failure.find("leaves 4"), std::string::npos);
}

TEST(VerifyReport, PassesOnlyWhenSomethingWasCheckedAndNothingIsWrong) {
    VerifyReport report;
    EXPECT_FALSE(report.passed());
    report.rows.resize(1);
    EXPECT_TRUE(report.passed());
    report.rows[0].ties = 3;
    EXPECT_TRUE(report.passed());
    report.rows[0].counter_mismatches = 1;
    EXPECT_FALSE(report.passed());
    report.rows[0].counter_mismatches = 0;
    report.violations = {"paper: node 3: no"};
    EXPECT_FALSE(report.passed());
    report.violations.clear();
    report.complete = false;
    EXPECT_FALSE(report.passed());
}

std::string failures(const VerifyReport& report) {
    std::string text;
    for (const VerifyRow& row : report.rows)
        if (!row.first_failure.empty())
            text += row.builder + " " + row.traversal + " " + row.tracer + " " + row.context + ": " +
                    row.first_failure + "\n";
    for (const std::string& violation : report.violations) text += violation + "\n";
    return text;
}

/// Small enough for a test: 48x48 pixel rays and 1300 adversarial ones, on the CPU.
VerifyConfig small_config() {
    VerifyConfig config;
    config.width = config.height = 48;
    config.adversarial_rays = 1300;
    config.seed = 6;
    return config;
}

/// Those that agree with the CPU bit for bit: hardware need not.
std::vector<ContextKind> software_contexts() {
    std::vector<ContextKind> kinds;
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
        try {
            if (Context::create(kind)->is_software()) kinds.push_back(kind);
        } catch (const ContextError&) {
            continue;  // this machine does not have that one
        }
    }
    return kinds;
}

/// What rows were traced through and on, each with the bytes of the nodes that it has met.
using NodesMet = std::set<std::pair<std::string, int>>;

NodesMet nodes_met(const VerifyReport& report) {
    NodesMet met;
    for (const VerifyRow& row : report.rows)
        for (const std::string& name : {row.builder, row.traversal, row.tracer + row.context})
            met.insert({name, row.node_bytes});
    return met;
}

/// Each builder, traversal and machine meets both kinds of nodes, but for walks that need parents.
NodesMet nodes_to_meet(const std::vector<ContextKind>& contexts) {
    NodesMet wanted{{"-", 0}, {"naive", 0}, {"cpu-", 16}, {"cpu-", 8}};
    for (const int bytes : {16, 8}) {
        for (const Builder& builder : builders()) wanted.emplace(builder.name, bytes);
        for (const TraversalInfo& t : traversals())
            if (t.id != Traversal::naive && (bytes == 16 || !t.has(walk_parents))) wanted.emplace(t.name, bytes);
    }
    for (const ContextKind kind : contexts)
        for (const int bytes : {16, 8, 0}) wanted.emplace("gl-fragment" + std::string(name_of(kind)), bytes);
    return wanted;
}

TEST(Verify, CpuAndGlAgreeWithBruteForce) {
    VerifyConfig config = small_config();
    config.contexts = software_contexts();
    if (config.contexts.empty()) GTEST_SKIP() << "NO CONTEXT: neither OSMesa nor EGL in software";
    for (const FlatScene& scene : {test::scene_of(test::voxel_city(4)), test::scene_of(test::random_soup(400, 0.2f, 9)),
                                   test::scene_of(test::stress_sphere(16, 9))}) {
        const VerifyReport report = verify(scene, {}, config);
        EXPECT_TRUE(report.passed()) << failures(report);
        EXPECT_EQ(nodes_met(report), nodes_to_meet(config.contexts));
        for (const ContextKind kind : config.contexts) {
            // Naive once, the others for each builder, the stack with both layouts of the leaf lists, and a diagonal of
            // builders and traversals with the other nodes.
            const auto rows = std::ranges::count(report.rows, name_of(kind), &VerifyRow::context);
            const std::size_t diagonal = std::max(builders().size(), traversals().size() - 2);
            EXPECT_EQ(rows, std::ptrdiff_t(1 + builders().size() * traversals().size() + diagonal)) << name_of(kind);
        }
        for (const VerifyRow& row : report.rows) {
            EXPECT_EQ(row.pixel_rays, 48 * 48) << row.traversal;
            const bool compared = (row.tracer == "gl-fragment" && row.traversal != "naive") || row.node_bytes == 8;
            EXPECT_EQ(row.counter_mismatches.has_value(), compared) << row.traversal << " " << row.tracer;
        }
    }
}

TEST(Verify, NodesThatAreAskedForAlone) {
    VerifyConfig config = small_config();
    config.builders = {"paper"};
    config.traversals = {"stack", "backtrack"};
    config.nodes = NodeEncoding::packed;
    const VerifyReport report = verify(test::scene_of(test::random_soup(50, 0.2f, 4)), {}, config);
    EXPECT_TRUE(report.passed()) << failures(report);
    EXPECT_EQ(nodes_met(report),
              (NodesMet{{"paper", 8}, {"stack", 8}, {"cpu-", 8}, {"paper", 16}, {"backtrack", 16}, {"cpu-", 16}}));
}

TEST(Verify, OneTriangleAndNoTriangle) {
    VerifyConfig config = small_config();
    config.seed = 1;
    for (const FlatScene& scene : {test::scene_of({}), test::scene_of(test::random_soup(1, 0.5f, 2))}) {
        const VerifyReport report = verify(scene, {}, config);
        EXPECT_TRUE(report.passed()) << failures(report);
    }
}

TEST(Verify, ManyTrianglesGetStratifiedRaysAndSaySo) {
    VerifyConfig config = small_config();
    config.every_pixel_limit = 100;
    config.stratified_rays = 256;
    config.builders = {"paper"};
    config.traversals = {"restart"};
    const VerifyReport report = verify(test::scene_of(test::random_soup(300, 0.2f, 1)), {}, config);
    ASSERT_EQ(report.rows.size(), 3u);  // with both layouts of the leaf lists, and both of nodes
    EXPECT_EQ(report.rows[1].node_bytes, 8);
    EXPECT_EQ(report.rows[2].leaf_lists, "duplicated");
    EXPECT_EQ(report.rows[0].pixel_rays, 256);
    EXPECT_EQ(report.rows[0].traversal, "restart");
    ASSERT_FALSE(report.notes.empty());
    EXPECT_NE(report.notes[0].find("256 pixel rays"), std::string::npos);
}

TEST(Verify, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const VerifyReport report = verify(test::scene_of(test::voxel_city(3)), {}, small_config(), {}, stop.get_token());
    EXPECT_FALSE(report.complete);
    EXPECT_FALSE(report.passed());
    EXPECT_TRUE(report.rows.empty());
}

}  // namespace
}  // namespace kd
