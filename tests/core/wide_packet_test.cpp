// Eight triangles at once and rays that walk together, against the shared text: the same hits and counters in every
// bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/leaf_blocks.h"
#include "renderer/kdtree/build.h"
#include "renderer/kdtree/encode.h"
#include "renderer/kdtree/sah.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/support/instruction_sets.h"

namespace kd {
namespace {

TEST(LeafBlocks, HoldEachLeafsTrianglesAndRepeatTheLast) {
    const FlatScene scene = flatten(*make_procedural("scatter:300"));
    const KdTree tree = build_tree(scene.triangles, {.leaf_size = 20, .leaf_block = block_size});
    const KdTree over = tree_over_blocks(tree);
    const std::vector<LeafBlock> made = make_leaf_blocks(tree, over, scene.triangles, 2);
    ASSERT_EQ(over.nodes.size(), tree.nodes.size());
    std::size_t blocks = 0;
    for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
        const TreeNode& leaf = tree.nodes[node];
        if (!leaf.is_leaf()) continue;
        ASSERT_EQ(over.nodes[node].count, leaf.count);
        ASSERT_EQ(over.nodes[node].link, std::int32_t(blocks));
        for (int i = 0; i < blocks_of(leaf.count) * block_size; ++i) {
            const std::int32_t number = tree.references[std::size_t(leaf.link + std::min(i, leaf.count - 1))];
            const LeafBlock& block = made[blocks + std::size_t(i / block_size)];
            const auto lane = std::size_t(i % block_size);
            EXPECT_EQ(block.triangle[lane], number);
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_EQ(block.corner[corner][std::size_t(axis)][lane],
                              scene.triangles[std::size_t(number)].corner[corner][axis]);
        }
        blocks += std::size_t(blocks_of(leaf.count));
    }
    EXPECT_EQ(made.size(), blocks);
}

class LeafBlockTables : public testing::Test {
  protected:
    const FlatScene scene = flatten(*make_procedural("ball:300"));
    const KdTree tree = build_tree(scene.triangles, {.leaf_block = block_size});
    const std::size_t blocks = make_leaf_blocks(tree, tree_over_blocks(tree), scene.triangles).size();
    CpuTracer tracer{scene, tree, CpuMode::wide};

    /// Of `config`, as made, as known before, and as they should be.
    void expect_bytes(const TraceConfig& config, std::size_t of_a_node) {
        EXPECT_TRUE(tracer.prepare(config));
        const auto in_blocks = std::int64_t(blocks * sizeof(LeafBlock));
        EXPECT_EQ(tracer.table_bytes(), in_blocks + std::int64_t(tree.nodes.size() * of_a_node));
        const SceneNeeds needs = scene_needs(scene_facts(scene, tree), config);
        EXPECT_EQ(cpu_table_bytes(tree, needs, CpuMode::wide), tracer.table_bytes() - in_blocks);
    }
};

TEST_F(LeafBlockTables, AreCountedAndNothingStandsTwice) {
    expect_bytes({}, sizeof(TreeNode));
    expect_bytes({.leaf_lists = LeafLists::duplicated}, sizeof(TreeNode));  // blocks are copies
    expect_bytes({.nodes = NodeEncoding::packed}, sizeof(PackedNode));
    expect_bytes({.traversal = Traversal::restart, .nodes = NodeEncoding::packed}, sizeof(PackedNode));
    expect_bytes({}, sizeof(TreeNode));
    tracer.prepare({.rules = Rules::as_published});  // a triangle at a time
    EXPECT_EQ(tracer.table_bytes(), 0);
}

TEST_F(LeafBlockTables, CanBeStoppedAndAskedForAgain) {
    std::stop_source stopped;
    stopped.request_stop();
    const std::vector<Ray> ray{{scene.camera.eye, scene.camera.target - scene.camera.eye, 0.0f, KD_T_LIMIT, -1}};
    std::vector<Hit> hit(1), expected(1);
    EXPECT_FALSE(tracer.prepare({}, 1, stopped.get_token()));
    EXPECT_FALSE(tracer.trace_rays({}, ray, false, hit, {}, 1, stopped.get_token()));
    EXPECT_TRUE(tracer.trace_rays({}, ray, false, hit, {}, 1));
    CpuTracer(scene, tree).trace_rays({}, ray, false, expected, {}, 1);
    EXPECT_TRUE(bit_equal(hit[0], expected[0]));
}

TEST(LeafBlocks, ATestIsPaidForEachBlock) {
    const BuildConfig eight{.intersection_cost = 2.0f, .leaf_block = 8};
    EXPECT_EQ(leaf_cost(eight, 0), 0.0);
    EXPECT_EQ(leaf_cost(eight, 1), 2.0);
    EXPECT_EQ(leaf_cost(eight, 8), 2.0);
    EXPECT_EQ(leaf_cost(eight, 9), 4.0);
    EXPECT_EQ(leaf_cost({.intersection_cost = 2.0f}, 9), 18.0);
    // The halves of a unit cube, one triangle below and nine above: t_t + t_i (2/3 * 1 + 2/3 * 2).
    const Aabb cube{Vec3(0), Vec3(1)};
    BuildConfig config = eight;
    config.empty_bonus = 0;
    EXPECT_DOUBLE_EQ(SplitCost(config, cube, 0)(0.5f, 1, 9), 1.0 + 2.0 * (2.0 / 3 + 4.0 / 3));
}

/// Rays that agree and rays that do not, along axes, from afar, with ends, and some that are none.
std::vector<Ray> mixed_rays(const FlatScene& scene, std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-1, 1);
    const Vec3 centre = 0.5f * (scene.bounds.lower + scene.bounds.upper);
    const float size = glm::length(scene.bounds.upper - scene.bounds.lower);
    const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    std::vector<Ray> rays;
    Vec3 from = centre + size * any(), towards = centre - from;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 37 == 0) {
            from = centre + size * any();
            towards = centre - from;
        }
        Ray ray{from, towards + 0.1f * size * any(), 0.0f, KD_T_LIMIT, -1};
        if (i % 11 == 3) ray.direction = any();
        if (i % 13 == 5) AXIS(ray.direction, int(i % 3)) = i % 2 ? 0.0f : -0.0f;
        if (i % 17 == 7) ray.origin = ray.origin + 1e4f * size * any(), ray.direction = centre - ray.origin;
        if (i % 19 == 2) ray.t_max = 0.9f;
        if (i % 23 == 4) ray.t_min = 0.7f;
        if (i % 29 == 6) ray.source = int(i % scene.triangles.size());
        if (i % 31 == 9) ray.direction = Vec3(0);
        if (i % 41 == 1) ray.origin = scene.triangles[i % scene.triangles.size()].corner[0];
        rays.push_back(ray);
    }
    return rays;
}

struct Answers {
    std::vector<Hit> hits;
    std::vector<RayCounters> counters;
};

Answers answers(CpuTracer& tracer, const TraceConfig& config, const std::vector<Ray>& rays, bool any_hit) {
    Answers found{std::vector<Hit>(rays.size()), std::vector<RayCounters>(rays.size())};
    tracer.trace_rays(config, rays, any_hit, found.hits, found.counters, 1);
    return found;
}

class WidePacket : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, WidePacket, testing::Values("ball:300", "scatter:500", "rooms", "sheet:200"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::ranges::replace(name, ':', '_');
                             return name;
                         });

TEST_P(WidePacket, AnswersAndCountsAsTheSharedTextDoes) {
    const FlatScene scene = flatten(*make_procedural(GetParam()));
    const std::vector<Ray> rays = mixed_rays(scene, 3001);
    for (const int block : {1, 8}) {
        const KdTree tree = build_tree(scene.triangles, {.leaf_size = block, .leaf_block = block});
        CpuTracer scalar(scene, tree), wide(scene, tree, CpuMode::wide), packet(scene, tree, CpuMode::packet);
        for (const NodeEncoding nodes : {NodeEncoding::float4, NodeEncoding::packed})
            for (const bool any_hit : {false, true}) {
                TraceConfig config{.nodes = nodes};
                const Answers expected = answers(scalar, config, rays, any_hit);
                const auto expect_the_same = [&](CpuTracer& tracer) {
                    const Answers found = answers(tracer, config, rays, any_hit);
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        ASSERT_TRUE(bit_equal(found.hits[i], expected.hits[i])) << i;
                        ASSERT_TRUE(found.counters[i] == expected.counters[i]) << i;
                    }
                };
                SCOPED_TRACE(testing::Message() << "blocks of " << block << ", any hit " << any_hit);
                test::on_each_instruction_set([&] {
                    expect_the_same(scalar);
                    expect_the_same(wide);
                    for (const int size : {4, 8, 16}) {
                        SCOPED_TRACE(testing::Message() << "packets of " << size);
                        config.packet_size = size;
                        expect_the_same(packet);
                    }
                });
            }
    }
}

TEST(WidePackets, RunWithEveryInstructionSet) {
    std::set<std::string> names;
    const std::string best = cpu_target_name();
    test::on_each_instruction_set([&] { names.insert(cpu_target_name()); });
    EXPECT_EQ(names.size(), hwy::SupportedAndGeneratedTargets().size());
    EXPECT_TRUE(names.contains(best));
    EXPECT_EQ(cpu_target_name(), best);
}

TEST(WidePackets, OtherWalksAndRulesComeToWhatTheyCan) {
    TraceConfig config;
    EXPECT_EQ(mode_in_force(CpuMode::packet, config, false), CpuMode::packet);
    EXPECT_EQ(mode_in_force(CpuMode::packet, config, true), CpuMode::scalar) << "holes are looked for one by one";
    config.traversal = Traversal::ropes;
    EXPECT_EQ(mode_in_force(CpuMode::packet, config, false), CpuMode::wide);
    config.rules = Rules::as_published;
    EXPECT_EQ(mode_in_force(CpuMode::wide, config, false), CpuMode::scalar);
    config = {.traversal = Traversal::naive};
    EXPECT_EQ(mode_in_force(CpuMode::packet, config, false), CpuMode::scalar);
}

}  // namespace
}  // namespace kd
