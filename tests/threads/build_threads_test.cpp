// Trees are built on many threads: the same tree for any number of them, and progress and stopping work.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/cell.h"
#include "renderer/kdtree/grow.h"
#include "renderer/kdtree/phases.h"
#include "renderer/kdtree/stats.h"
#include "tests/core/tree_checks.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

/// Enough triangles for several rounds and parts.
const std::vector<Triangle>& many_triangles() {
    static const std::vector<Triangle> soup = test::random_soup(int(3 * part_size), 0.05f, 21);
    return soup;
}

struct Built {
    KdTree tree;
    BuildReport report;
};

Built build(const BuildConfig& config, int threads) {
    Built built;
    built.tree = build_tree(many_triangles(), config, &built.report, {}, {}, threads);
    return built;
}

void expect_same(const BuildConfig& config) {
    SCOPED_TRACE(config.builder);
    const Built one = build(config, 1);
    EXPECT_EQ(test::faults(one.tree, many_triangles()), "");
    for (const int threads : {2, 3, 8}) {
        const Built many = build(config, threads);
        EXPECT_TRUE(many.tree == one.tree) << threads << " threads";
        EXPECT_EQ(many.report.depth_limit_hit, one.report.depth_limit_hit);
        EXPECT_EQ(many.report.reference_cap_hit, one.report.reference_cap_hit);
        EXPECT_EQ(many.report.idle_hand_splits, one.report.idle_hand_splits);
    }
}

TEST(BuildThreads, MakeTheSameTree) {
    for (const Builder& builder : builders()) expect_same({.builder = std::string(builder.name)});
}

TEST(BuildThreads, MakeTheSameTreeWithinTightLimits) {
    for (const Builder& builder : builders()) {
        BuildConfig config{.builder = std::string(builder.name), .bad_refines = 2, .reference_cap = 1.5f};
        expect_same(config);
        EXPECT_TRUE(build(config, 2).report.reference_cap_hit) << builder.name;
        EXPECT_LE(double(build(config, 2).tree.references.size()), 1.5 * double(many_triangles().size()));
    }
}

TEST(BuildThreads, RefuseNothingToATreeThatKeepsTheCapAsAWhole) {
    for (const Builder& builder : builders()) {
        SCOPED_TRACE(builder.name);
        BuildConfig config{.builder = std::string(builder.name)};
        const Built free = build(config, 2);
        ASSERT_FALSE(free.report.reference_cap_hit);
        const float per_triangle = float(double(free.tree.references.size()) / double(many_triangles().size()));
        config.reference_cap = std::nextafter(per_triangle, 2.0f * per_triangle);
        EXPECT_TRUE(build(config, 2).tree == free.tree) << "not one reference too many";
        EXPECT_FALSE(build(config, 2).report.reference_cap_hit);
        config.reference_cap = std::nextafter(per_triangle, 0.0f);
        EXPECT_TRUE(build(config, 2).report.reference_cap_hit) << "one too many";
        expect_same(config);
    }
}

TEST(BuildThreads, ATreeThatWasNotKeptTellsNothing) {
    BuildConfig config{.builder = "spatial-median", .bad_refines = 20, .reference_cap = 1.5f};
    const std::vector<int> depths = node_depths(build(config, 1).tree);
    config.max_depth = *std::ranges::max_element(depths) + 1;  // that the tree without a cap goes beyond
    const Built kept = build(config, 1);
    ASSERT_TRUE(kept.report.reference_cap_hit);
    EXPECT_FALSE(kept.report.depth_limit_hit);
}

TEST(BuildThreads, PutPlanesByHandInPartsAndAboveThem) {
    // Above the parts two cells of at least 4096 triangles each; the third within a part.
    const std::string deep(7, path_below);
    BuildConfig config{.by_hand = {{"", 0, 0.1f}, {"ab", 1, 0.2f}}};
    const KdTree above = build(config, 1).tree;
    const Aabb cell = cell_of(above, *node_at(above, deep)).box;
    config.by_hand.push_back({deep, 2, 0.7f * cell.lower.z + 0.3f * cell.upper.z});
    config.by_hand.push_back({"a", 0, 9.0f});
    expect_same(config);
    const Built built = build(config, 2);
    EXPECT_EQ(built.report.hand_splits, 4);
    EXPECT_EQ(built.report.idle_hand_splits, 1) << "one lies outside";
    for (std::size_t i = 0; i < 3; ++i) {
        const TreeNode& node = built.tree.nodes[std::size_t(*node_at(built.tree, config.by_hand[i].path))];
        EXPECT_EQ(node.flag, config.by_hand[i].axis) << config.by_hand[i].path;
        EXPECT_EQ(node.split, config.by_hand[i].position) << config.by_hand[i].path;
    }
}

TEST(BuildThreads, TellProgressOneAtATime) {
    std::atomic<int> inside = 0;
    float last = 0.0f;
    const auto progress = [&](float done) {
        EXPECT_EQ(inside.fetch_add(1), 0);
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1.0f);
        last = done;
        inside.fetch_sub(1);
    };
    for (const float cap : {64.0f, 1.5f}) {  // the second grows twice
        last = 0.0f;
        (void)build_tree(many_triangles(), {.builder = "exact", .bad_refines = 2, .reference_cap = cap}, nullptr,
                         progress, {}, 4);
        EXPECT_EQ(last, 1.0f);
    }
}

TEST(BuildThreads, StopHalfWayWithASoundTree) {
    for (const Builder& builder : builders()) {
        std::stop_source stop;
        const auto progress = [&](float done) {
            if (done > 0.4f) stop.request_stop();
        };
        const BuildConfig config{.builder = std::string(builder.name)};
        const KdTree tree = build_tree(many_triangles(), config, nullptr, progress, stop.get_token(), 4);
        EXPECT_EQ(test::faults(tree, many_triangles()), "") << builder.name;
        EXPECT_LT(tree.nodes.size(), build(config, 4).tree.nodes.size()) << builder.name;
    }
}

TEST(BuildThreads, EveryPhaseIsTimedAndTogetherTheyFitIntoTheBuild) {
    for (const int threads : {1, 2}) {
        const BuildReport report = build({.builder = "exact"}, threads).report;
        const BuildPhases& p = report.phases;
        for (const double phase : {p.prepare, p.choose, p.divide, p.leaves}) EXPECT_GT(phase, 0.0);
        EXPECT_LE(p.sum(), threads * report.seconds);
    }
}

TEST(PhaseClock, AnInterruptedSampleCountsForNothing) {
    BuildPhases phases;
    PhaseClock clock(phases);
    for (int cell = 0; cell < 16; ++cell) {  // one of them is timed
        clock.begin_cell(1);
        if (cell == 15) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        clock.end(&BuildPhases::choose);
    }
    EXPECT_EQ(phases.choose, 0.0);
}

TEST(PhaseClock, PhasesTakeNoMoreThanTheThreadsTime) {
    BuildPhases phases;
    PhaseClock clock(phases);
    clock.begin_cell(1 << 20);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    clock.end(&BuildPhases::choose);
    EXPECT_GE(phases.choose, 0.05);
    clock.finish();
    EXPECT_GT(phases.choose, 0.0);
    EXPECT_LT(phases.choose, 0.05) << "asleep, a thread takes no time of a processor";
}

}  // namespace
}  // namespace kd
