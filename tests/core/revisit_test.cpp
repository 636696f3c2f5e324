// The split into first visits and re-visits, held against a set of the nodes that each ray has been at.

#include <gtest/gtest.h>

#include <set>

#include "renderer/cpu/scene_view.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/kdtree/build.h"
#include "renderer/trace/observer.h"
#include "tests/support/scenes.h"

namespace kd {
namespace test_kernel {
#include "renderer/cpu/kernel.h"
}  // namespace test_kernel

namespace {

struct SetObserver : NullObserver {
    std::set<int> interior, leaves;
    bool consistent = true, ropes = false;
    int again_count = 0, detours = 0;

    void on_interior(int node, bool again) {
        if (interior.insert(node).second == again) consistent = false;
        again_count += again;
    }
    void on_leaf(int node) {
        if (!leaves.insert(node).second) consistent = false;
    }
    void on_restart() {
        ++detours;
        // A ray that leaves its ropes for kd-restart begins a walk of its own.
        if (ropes && detours == 1) {
            interior.clear();
            leaves.clear();
        }
    }
    void on_backtrack() { ++detours; }
};

/// Walks every ray and returns the number of re-visits.
template <Rules rules>
int check(Traversal traversal, const FlatScene& scene, const KdTree& tree, const std::vector<Ray>& rays) {
    SCOPED_TRACE(info(traversal).name);
    TraceConfig config;
    config.traversal = traversal;
    SceneView view(scene, tree);
    view.prepare(config);
    int again = 0;
    for (const Ray& ray : rays) {
        SetObserver seen;
        seen.ropes = traversal == Traversal::ropes;
        test_kernel::Kernel<SetObserver, rules> kernel(view, config, seen);
        Hit hit = kernel.no_hit(ray);
        kernel.traverse(ray, false, hit);
        EXPECT_TRUE(seen.consistent) << test::hex(ray);
        EXPECT_TRUE(seen.again_count == 0 || seen.detours > 0) << "re-visits without a way back: " << test::hex(ray);
        again += seen.again_count;
        if (testing::Test::HasFailure()) break;
    }
    return again;
}

template <Rules rules>
void check_all(const FlatScene& scene, const KdTree& tree, const std::vector<Ray>& rays) {
    for (const TraversalInfo& t : traversals()) (void)check<rules>(t.id, scene, tree, rays);
}

TEST(Revisit, FlagMeansThatThisRayHasBeenThere) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.05f, 21));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 3000, 6);
    check_all<Rules::robust>(scene, tree, rays);
}

TEST(Revisit, AStackSparesWhatRestartAndBacktrackPay) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.05f, 21));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 300, 6);
    EXPECT_EQ(check<Rules::robust>(Traversal::stack, scene, tree, rays), 0);
    const int restart = check<Rules::robust>(Traversal::restart, scene, tree, rays);
    const int backtrack = check<Rules::robust>(Traversal::backtrack, scene, tree, rays);
    EXPECT_GT(backtrack, 1000);
    EXPECT_GT(restart, backtrack);
}

TEST(Revisit, HoldsOnLatticeScenes) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 3000, 6);
    check_all<Rules::robust>(scene, tree, rays);
}

TEST(Revisit, HoldsForWalksAsPublishedWhereTheyAreSound) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.05f, 21));
    const KdTree tree = build_tree(scene.triangles, {});
    test::Random random(8);
    std::vector<Ray> rays;
    for (int i = 0; i < 3000; ++i) rays.push_back({random.point(-1, 2), random.point(-1, 1), 0.0f, KD_T_LIMIT, -1});
    check_all<Rules::as_published>(scene, tree, rays);
}

}  // namespace
}  // namespace kd
