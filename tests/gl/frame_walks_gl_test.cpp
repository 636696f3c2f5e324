// Groups of a real frame's rays: the invariants that hold whatever the scene.

#include "renderer/measure/frame_walks.h"

#include <cmath>
#include <gtest/gtest.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

constexpr int width = 70, height = 50;

struct Subject {
    explicit Subject(const std::string& name) : scene(flatten(*make_procedural(name))) {}

    [[nodiscard]] WalkRequest request(const TraceConfig& config = {}, Pass rays = Pass::rt_prim) const {
        return {.scene = scene,
                .tree = tree,
                .config = config,
                .camera = camera,
                .width = width,
                .height = height,
                .rays = rays};
    }
    [[nodiscard]] LockstepLayer layer(Schedule schedule, int w, int h, Pass rays = Pass::rt_prim) const {
        return walk_frame(request({}, rays), schedule, w, h).value();
    }

    FlatScene scene;
    KdTree tree = build_tree(scene.triangles, {});
    PinholeCamera camera = pinhole(scene.camera, width, height);
};

TEST(WalkFrame, LiesBetweenOneLaneAndAll) {
    const Subject cornell("cornell");
    for (const ScheduleInfo& schedule : schedules())
        for (const auto& [w, h] :
             {std::pair(8, 4), std::pair(2, 2), std::pair(7, 3), std::pair(64, 16), std::pair(1, 5)})
            for (int pass = 0; pass < pass_count; ++pass) {
                const LockstepLayer layer = cornell.layer(schedule.id, w, h, Pass(pass));
                for (const LockstepGroup& group : layer.groups) {
                    if (group.tally.iterations == 0) continue;
                    const double e = group.tally.efficiency(w * h);
                    EXPECT_GE(e, 1.0 / (w * h));
                    EXPECT_LE(e, 1.0);
                    EXPECT_LE(group.reads.iterations, group.tally.iterations);
                    EXPECT_LE(group.reads.lines, group.reads.sectors);
                    EXPECT_LE(group.reads.sectors, group.reads.nodes);
                    EXPECT_LE(group.reads.nodes, group.reads.lanes);
                    EXPECT_GE(group.reads.lines, group.reads.iterations);
                    EXPECT_LE(group.triangles, group.rays);
                    EXPECT_LE(group.leaves, group.rays);
                }
            }
}

TEST(WalkFrame, TheIdealisedScheduleIsTheCountersOwn) {
    const Subject cornell("cornell");
    Frame frame(width, height);
    CpuTracer(cornell.scene, cornell.tree).trace_frame({}, cornell.camera, frame);
    for (const Pass pass : {Pass::rt_prim, Pass::shade_prim, Pass::rt_refl, Pass::shade_refl}) {
        const LockstepLayer layer = cornell.layer(Schedule::lockstep, 8, 4, pass);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const RayCounters& c = frame.layer(pass).counters.at(x, y);
                const auto steps = std::int64_t(c.interior_first) + c.interior_again + c.leaves + c.triangle_tests;
                EXPECT_EQ(std::max<std::int64_t>(layer.steps.at(x, y), 0), steps);
                EXPECT_LE(std::uint64_t(steps), layer.group_at(x, y).tally.iterations);
            }
    }
}

TEST(WalkFrame, NoScheduleBeatsTheIdealisedOneWithOneLight) {
    const Subject ball("ball:1000");
    const LockstepLayer ideal = ball.layer(Schedule::lockstep, 8, 4);
    for (const Schedule schedule : {Schedule::if_if, Schedule::while_while}) {
        const LockstepLayer layer = ball.layer(schedule, 8, 4);
        for (std::size_t i = 0; i < layer.groups.size(); ++i) {
            EXPECT_EQ(layer.groups[i].tally.steps, ideal.groups[i].tally.steps);
            EXPECT_GE(layer.groups[i].tally.iterations, ideal.groups[i].tally.iterations);
        }
    }
}

TEST(WalkFrame, ThreadsAndBlocksChangeNothing) {
    const Subject ball("ball:1000");
    WalkRequest alone = ball.request();
    alone.threads = 1;
    const LockstepLayer one = walk_frame(alone, Schedule::while_while, 8, 4).value();
    const LockstepLayer all = ball.layer(Schedule::while_while, 8, 4);
    EXPECT_EQ(one.groups, all.groups);
    EXPECT_EQ(one.steps.pixels, all.steps.pixels);
}

TEST(WalkFrame, AStackHasNoOverheadAndRestartHas) {
    const Subject ball("ball:1000");
    const LockstepLayer stack = ball.layer(Schedule::while_while, 8, 4);
    EXPECT_EQ(stack.unlike_hits, 0);
    EXPECT_EQ(stack.whole_overhead, 1.0);
    for (const float r : stack.overhead.pixels) EXPECT_TRUE(std::isnan(r) || r == 1.0f);
    const LockstepLayer restart =
        walk_frame(ball.request({.traversal = Traversal::restart}), Schedule::while_while, 8, 4).value();
    EXPECT_EQ(restart.unlike_hits, 0);
    EXPECT_GT(restart.whole_overhead, 1.5);
}

TEST(WalkFrame, EntryPointsSaveTheStepsAboveThem) {
    const Subject ball("ball:1000");
    const LockstepLayer root = ball.layer(Schedule::while_while, 8, 4);
    EXPECT_EQ(root.entry, "the root");
    EXPECT_EQ(root.share_saved, 0.0);
    for (const Image<float>* map : {&root.entry_depth, &root.steps_saved})
        for (std::size_t i = 0; i < map->pixels.size(); ++i) ASSERT_EQ(map->pixels[i], 0.0f) << i;

    for (const Traversal traversal : {Traversal::stack, Traversal::restart, Traversal::backtrack}) {
        const TraceConfig from_root{.traversal = traversal};
        const TraceConfig from_tiles{.traversal = traversal, .entry_tile = 8};
        const LockstepLayer without = walk_frame(ball.request(from_root), Schedule::while_while, 8, 4).value();
        const LockstepLayer with = walk_frame(ball.request(from_tiles), Schedule::while_while, 8, 4).value();
        EXPECT_EQ(with.entry, "8×8 px tiles");
        EXPECT_GT(with.share_saved, 0.05);
        EXPECT_EQ(with.unlike_hits, 0);
        std::int64_t all = 0, saved = 0;
        for (std::size_t i = 0; i < with.steps.pixels.size(); ++i) {
            // The whole walk is recorded from the root, too: what is saved is the difference of the two recordings.
            ASSERT_EQ(with.steps_saved.pixels[i], float(without.steps.pixels[i] - with.steps.pixels[i])) << i;
            all += without.steps.pixels[i];
            saved += without.steps.pixels[i] - with.steps.pixels[i];
            // A walk that enters the entry's cell comes to it from the root through every node above it.
            if (with.steps.pixels[i] > 0) {
                ASSERT_GE(with.steps_saved.pixels[i], with.entry_depth.pixels[i]) << i;
            }
        }
        EXPECT_DOUBLE_EQ(with.share_saved, double(saved) / double(all));
    }
}

TEST(WalkFrame, RopesFromTheEyesLeafBeginThere) {
    const Subject rooms("rooms");
    const LockstepLayer layer =
        walk_frame(rooms.request({.traversal = Traversal::ropes, .eye_leaf = true}), Schedule::while_while, 8, 4)
            .value();
    EXPECT_EQ(layer.entry, "the eye's leaf");
    const float depth = layer.entry_depth.at(0, 0);
    EXPECT_GT(depth, 0.0f);
    for (const float each : layer.entry_depth.pixels) ASSERT_EQ(each, depth) << "all rays have one eye";
    EXPECT_GT(layer.share_saved, 0.0);
}

TEST(WalkFrame, PublishedRulesFindOtherHitsThanTheirStack) {
    const Subject rooms("rooms");
    const TraceConfig config{.traversal = Traversal::restart, .rules = Rules::first_edition};
    const LockstepLayer layer = walk_frame(rooms.request(config), Schedule::while_while, 8, 4).value();
    EXPECT_GT(layer.unlike_hits, 0) << "restart under these rules does not end";
}

TEST(MeasureDivergence, IsWhatEachShapeIsAlone) {
    const Subject ball("ball:1000");
    const DivergenceReport report =
        measure_divergence(ball.request({.traversal = Traversal::restart}), width_curve()).value();
    EXPECT_EQ(report.pixels, width * height);
    EXPECT_EQ(report.unlike_hits, 0);
    EXPECT_GT(report.overhead, 1.5);
    ASSERT_EQ(report.points.size(), width_curve().size());
    for (const DivergencePoint& point : report.points)
        for (const ScheduleInfo& schedule : schedules()) {
            const LockstepLayer layer = walk_frame(ball.request({.traversal = Traversal::restart}), schedule.id,
                                                   point.tile_width, point.tile_height)
                                            .value();
            const EfficiencySummary &a = point.by_schedule[std::size_t(schedule.id)], b = layer.efficiency();
            EXPECT_EQ(a.steps, b.steps);
            EXPECT_EQ(a.iterations, b.iterations) << schedule.name << " " << point.lanes();
            EXPECT_EQ(a.mean, b.mean);
            if (schedule.id != Schedule::while_while) continue;
            EXPECT_EQ(point.reads, layer.reads());
            EXPECT_NEAR(point.hits.triangles, correlate_hits(layer.groups, layer.lanes()).triangles, 1e-9);
        }
}

TEST(MeasureDivergence, WiderGroupsWaitMore) {
    const Subject ball("ball:1000");
    const DivergenceReport report = measure_divergence(ball.request(), width_curve()).value();
    for (std::size_t i = 1; i < report.points.size(); ++i)
        for (std::size_t s = 0; s < schedule_count; ++s)
            EXPECT_LT(report.points[i].by_schedule[s].weighted, report.points[i - 1].by_schedule[s].weighted)
                << "each group is made of whole ones of those before it";
    EXPECT_EQ(report.points.front().lanes(), 4);
    EXPECT_EQ(report.points.back().lanes(), 1024);
}

TEST(MeasureDivergence, Stops) {
    const Subject ball("ball:1000");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(measure_divergence(ball.request(), width_curve(), stop.get_token()));
    EXPECT_FALSE(walk_frame(ball.request(), Schedule::if_if, 8, 4, stop.get_token()));
}

}  // namespace
}  // namespace kd
