// What the paper's experiments count, without any clock: the sources of some of its contradictions.
#include "app/paper/paper_counts.h"

#include <gtest/gtest.h>

#include "renderer/measure/paper/paper_verdict.h"
#include "renderer/scene/procedural.h"

namespace kd {
namespace {

PaperConfig small() {
    PaperConfig config = paper_config(true);
    config.base.width = config.base.height = 64;
    return config;
}

PaperScene counted(const std::string& name) {
    const PaperConfig config = small();
    const std::unique_ptr<PaperWorld> world = open_world(config, name, 1, {});
    return count_scene(config, name, *world, {});
}

TEST(PaperCounts, BothReadingsOfTheDivergingScene) {
    for (const char* name : {"scatter:10000", "sheet:10000"}) {
        const PaperScene scene = counted(name);
        const bool cloud = name == std::string_view("scatter:10000");
        EXPECT_GT(scene.node_ratio(Traversal::restart), cloud ? 3.5 : 2.2) << name;
        EXPECT_LT(scene.node_ratio(Traversal::restart), cloud ? 5.5 : 2.9) << "the two readings differ";
        EXPECT_DOUBLE_EQ(scene.node_ratio(Traversal::stack), 1);
        const PaperConfig config = small();
        const double same = seed_node_ratio(config, name, 1, {}), other = seed_node_ratio(config, name, 2, {});
        EXPECT_DOUBLE_EQ(same, scene.node_ratio(Traversal::restart));
        EXPECT_NE(other, same) << "another seed makes another scene";
    }
}

TEST(PaperCounts, RestartCostIsNoDivergence) {
    // Were they one matter, the scene that pays more for restarts would keep its lanes less busy.
    const PaperScene scatter = counted("scatter:10000"), ball = counted("ball:9000");
    const auto efficiency = [](const PaperScene& scene) {
        return scene.counts_of(Traversal::restart)->step_efficiency;
    };
    EXPECT_GT(scatter.node_ratio(Traversal::restart), 1.3 * ball.node_ratio(Traversal::restart));
    EXPECT_GT(efficiency(scatter), 0.9 * efficiency(ball)) << "and yet its lanes are as busy";
    // All of the restart's extra work is visits: triangles tested and leaves are the stack's.
    for (const PaperScene* scene : {&scatter, &ball}) {
        const PaperCounts& stack = *scene->counts_of(Traversal::stack);
        const PaperCounts& restart = *scene->counts_of(Traversal::restart);
        EXPECT_EQ(stack.all.triangle_tests, restart.all.triangle_tests);
        EXPECT_EQ(stack.all.leaves, restart.all.leaves);
        EXPECT_EQ(stack.all.interior_first, restart.all.interior_first);
    }
}

TEST(PaperCounts, KdRestartVisitsTwiceAsManyNodesOnTheBallToo) {
    for (const char* name : {"ball:1000", "ball:4000", "ball:9000"}) {
        const PaperScene ball = counted(name);
        // At 512x512 it is 2.19, 2.32 and 2.46 times as many; a picture of 64x64 has fewer rays to tell it by.
        const double nodes = ball.node_ratio(Traversal::restart);
        EXPECT_GT(nodes, 2.0) << name;
        EXPECT_LT(nodes, 2.7) << name;
        // Beside leaves and triangle tests, which restarting does not repeat, that is still more work than 15 % of
        // 4.1, and more than twice of it; whether it shows in the time is up to what else a frame does.
        const auto work = [&](Traversal traversal) {
            const PaperCounts& counts = *ball.counts_of(traversal);
            return double(counts.visits() + counts.all.triangle_tests);
        };
        EXPECT_GT(work(Traversal::restart) / work(Traversal::stack), about_more(0.15).high) << name;
        EXPECT_LT(work(Traversal::restart) / work(Traversal::stack), nodes) << name;
    }
}

TEST(PaperCounts, RoomsHaveFewerRaysThatVisitMore) {
    const PaperScene rooms = counted("rooms"), ball = counted("ball:9000");
    const auto per_ray = [](const PaperScene& scene) {
        return double(scene.counts_of(Traversal::stack)->interior()) / double(scene.ray_sum());
    };
    EXPECT_LT(double(rooms.ray_sum()), 0.95 * double(ball.ray_sum()));
    EXPECT_EQ(rooms.rays[std::size_t(Pass::rt_refl)], 0) << "nothing is reflected there";
    EXPECT_GT(per_ray(rooms), 1.3 * per_ray(ball)) << "few triangles seen are no few visits";
}

TEST(PaperCounts, AFrameCastsFourKindsOfRays) {
    const PaperScene ball = counted("ball:1000");
    for (int pass = 0; pass < pass_count; ++pass)
        EXPECT_EQ(ball.rays[std::size_t(pass)] > 0, !of_indirect_light(Pass(pass))) << pass_names[std::size_t(pass)];
}

TEST(PaperCounts, ALowerCeilingGivesUpMorePixels) {
    const PaperConfig config = small();
    const std::unique_ptr<PaperWorld> world = open_world(config, "scatter:2000", 1, {});
    std::int64_t before = 64 * 64 + 1;
    for (const int budget : {32, 128, 255, 1024}) {
        PaperPicture picture;
        const PaperBudget row = limited_loop(config, "scatter:2000", *world, budget, &picture, {});
        EXPECT_LT(row.unfinished, before) << budget;
        EXPECT_EQ(row.pixels, 64 * 64);
        ASSERT_NE(picture.image, nullptr);
        EXPECT_EQ(picture.image->width, 64);
        EXPECT_NE(picture.caption.find(std::to_string(row.unfinished)), std::string::npos) << picture.caption;
        before = row.unfinished;
    }
    EXPECT_EQ(limited_loop(config, "scatter:2000", *world, 1 << 20, nullptr, {}).unfinished, 0);
}

TEST(PaperCounts, ACeilingThatIsReachedAt2KCutsOffMoreAt10K) {
    const PaperConfig config = small();
    const auto unfinished = [&](const char* name) {
        const std::unique_ptr<PaperWorld> world = open_world(config, name, 1, {});
        return limited_loop(config, name, *world, 255, nullptr, {}).unfinished;
    };
    const std::int64_t at_2k = unfinished("ball:2000");
    EXPECT_GT(at_2k, 0) << "reached, as section 5 says";
    EXPECT_GT(unfinished("ball:9000"), at_2k) << "and yet 4.1 shows it whole";
    EXPECT_GT(unfinished("scatter:10000"), 64 * 64 / 2) << "4.3 would show less than half of its picture";
}

TEST(PaperCounts, EveryScenesNameIsOneTheProgramKnows) {
    for (const PaperSceneInfo& scene : paper_scenes()) EXPECT_NE(find_procedural(scene.name), nullptr) << scene.name;
}

}  // namespace
}  // namespace kd
