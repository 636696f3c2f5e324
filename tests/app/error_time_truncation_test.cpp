// P5: what ends early loses what theory says, and nothing once nothing is ended.

#include <cmath>
#include <gtest/gtest.h>

#include "app/error_time/error_time_charts.h"
#include "app/error_time/error_time_faults.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/error_time/truncation_report.h"
#include "renderer/scene/flat_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/given_up.h"

namespace kd {
namespace {

constexpr int side = 24;

/// A closed room whose every surface emits `emission` and mirrors `reflectance` of what it sees.
FlatScene mirror_room(float emission, float reflectance) {
    Material material = matte(Vec3(0.0f));
    material.emission = Vec3(emission);
    material.reflectance = Vec3(reflectance);
    Mesh mesh{.name = "room"};
    add_box(mesh, {.lower = {-2, -2, -2}, .upper = {2, 2, 2}, .seen_from_inside = true});
    Scene scene;
    scene.ambient = Vec3(0.0f);
    place(scene, std::move(mesh), material);
    scene.lights.push_back(point_light({1, 1, 1}, Vec3(0.0f)));
    scene.camera = Camera{.eye = {0.3f, 0.8f, 1.9f}, .target = {0, 0, 0}, .fov_y_degrees = 60.0f};
    return flatten(scene);
}

WalkedFrame walked(const Frame& frame) {
    WalkedFrame found;
    for (std::size_t i = 0; i < frame.colour.pixels.size(); ++i) {
        bool given_up = false;
        for (const RayLayer& layer : frame.layers) {
            if (layer.counters.pixels.empty()) continue;
            const RayCounters& counters = layer.counters.pixels[i];
            given_up = given_up || was_given_up(counters.exit_reason);
            found.most_steps = std::max(found.most_steps, lane_steps(counters));
        }
        found.given_up += given_up;
    }
    return found;
}

/// By the CPU, whose clock stands still.
struct Truncated {
    FlatScene scene;
    KdTree tree = build_tree(scene.triangles, {});
    CpuTracer tracer{scene, tree};
    TruncationTask task;

    explicit Truncated(FlatScene of) : scene(std::move(of)) {
        task.width = task.height = side;
        task.seconds = 0;
        for (const Traversal walk : {Traversal::stack, Traversal::restart})
            task.methods.push_back({"cpu", std::string(info(walk).name), walk, "none",
                                    [this](const TraceConfig& config, Image<Vec4>& colour) {
                                        colour = traced(config).colour;
                                        return TimeSample{1.0};
                                    },
                                    [this](const TraceConfig& config) { return walked(traced(config)); }});
    }

    Frame traced(const TraceConfig& config) {
        Frame frame(side, side);
        tracer.trace_frame(config, pinhole(scene.camera, side, side), frame, 2);
        return frame;
    }
};

TEST(Truncation, WhatEveryBounceAddsIsWhatIsMirrored) {
    constexpr double emission = 0.25, reflectance = 0.5;
    Truncated truncated(mirror_room(float(emission), float(reflectance)));
    truncated.task.deepest = 7;
    truncated.task.budgets = false;
    const TruncationReport report = report_truncation(truncated.task);
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.curves.size(), 1u) << "depths by the machine's first method";
    const TruncationCurve& curve = report.curves.front();
    ASSERT_EQ(curve.points.size(), 8u);
    for (const TruncationPoint& point : curve.points) {
        EXPECT_EQ(point.frame.samples, 6);
        // emission * (r^(d+1) + ... + r^7): sums of powers of two, each exact.
        double lost = 0;
        for (int bounce = point.limit + 1; bounce <= 7; ++bounce) lost += emission * std::pow(reflectance, bounce);
        EXPECT_DOUBLE_EQ(point.rmse, lost) << point.limit;
        EXPECT_EQ(point.given_up, 0);
    }
    // The line through (2^-d - 2^-7) for d of 0 to 6 falls a little faster than the mirror has it.
    EXPECT_LT(curve.per_bounce, reflectance);
    EXPECT_GT(curve.per_bounce, 0.85 * reflectance);
    EXPECT_EQ(curve.telling_points(), 8u);
}

TEST(Truncation, NothingIsLostFromTheMostStepsOfAnyRayOn) {
    Truncated truncated(flatten(*make_procedural("ball:300")));
    truncated.task.deepest = 2;
    const TruncationReport report = report_truncation(truncated.task);
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.curves.size(), 3u) << "depths, and budgets by two walks";
    std::uint64_t largest_leaf = 0;
    for (const TreeNode& node : truncated.tree.nodes)
        if (node.is_leaf()) largest_leaf = std::max(largest_leaf, std::uint64_t(node.count));
    int budgets = 0;
    for (const TruncationCurve& curve : report.curves) {
        if (curve.what != Truncation::step_budget) continue;
        ++budgets;
        ASSERT_EQ(curve.points.size(), 8u);
        EXPECT_EQ(curve.points.front().limit, 32);
        EXPECT_EQ(curve.points.back().limit, 4096);
        EXPECT_GT(curve.points.front().rmse, 0.01) << "walks of 32 steps lose hits";
        EXPECT_GT(curve.points.front().given_up, 0);
        EXPECT_GT(curve.most_steps, 32u);
        for (const TruncationPoint& point : curve.points) {
            // Triangles count when their leaf is entered; of a last leaf some may be left untested.
            if (std::uint64_t(point.limit) > curve.most_steps + largest_leaf) {
                EXPECT_EQ(point.given_up, 0) << point.limit;
            }
            if (point.given_up == 0) {
                EXPECT_EQ(point.rmse, 0) << curve.traversal << ' ' << point.limit;
            }
        }
        EXPECT_EQ(curve.points.back().rmse, 0);
        EXPECT_TRUE(curve.wrong_limits().empty());
        EXPECT_LT(curve.telling_points(), 8u);
    }
    EXPECT_EQ(budgets, 2);
}

TEST(Truncation, StopsWhereAsked) {
    Truncated truncated(flatten(*make_procedural("ball:300")));
    std::stop_source stop;
    const auto progress = [&](float, const std::string&) { stop.request_stop(); };
    EXPECT_FALSE(report_truncation(truncated.task, progress, stop.get_token()).complete);
}

/// A scene whose curve of budgets has two points.
SceneErrorTime two_budgets(double error_of_the_second) {
    SceneErrorTime scene;
    scene.name = {"made:1", "made-1"};
    TruncationCurve curve{.machine = "cpu", .traversal = "stack", .clock = "none", .most_steps = 60, .points = {}};
    curve.points = {{.limit = 32, .frame = {1, 1, 1, 6}, .rmse = 0.5, .given_up = 9},
                    {.limit = 64, .frame = {2, 2, 2, 6}, .rmse = error_of_the_second}};
    scene.truncation.emplace().curves = {curve};
    return scene;
}

TEST(Truncation, ABudgetThatEndsNoWalkAndChangesTheImageIsAFault) {
    ErrorTimeResults results;
    results.scenes = {two_budgets(0)};
    EXPECT_TRUE(faults_of(results).empty());
    results.scenes = {two_budgets(0.001)};
    const std::vector<ErrorTimeFault> faults = faults_of(results);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].where(), "P5 of made:1");
    EXPECT_EQ(faults[0].what, "stack on cpu: a budget of 64 steps gives up no ray and changes the image");
}

TEST(Truncation, TheSameImageStandsOpenAtTheFoot) {
    const auto figures = truncation_figures(two_budgets(0));
    ASSERT_EQ(figures.size(), 1u) << "no depths were measured";
    EXPECT_EQ(figures[0].name, "p5-made-1-budgets");
    const auto& points = figures[0].chart.curves.at(0).points;
    ASSERT_EQ(points.size(), 2u);
    EXPECT_FALSE(points[0].bound);
    EXPECT_EQ(points[0].y, 0.5);
    EXPECT_TRUE(points[1].bound);
    EXPECT_EQ(points[1].y, 0.25) << "half of the least error that is one";
    EXPECT_EQ(points[1].x, 0.002);
}

}  // namespace
}  // namespace kd
