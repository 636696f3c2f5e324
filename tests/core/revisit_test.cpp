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
    bool consistent = true;
    int again_count = 0;

    void on_interior(int node, bool again) {
        if (interior.insert(node).second == again) consistent = false;
        again_count += again;
    }
    void on_leaf(int node) {
        if (!leaves.insert(node).second) consistent = false;
    }
};

template <Traversal traversal>
void check(const FlatScene& scene, const KdTree& tree, const std::vector<Ray>& rays) {
    SceneView view;
    view.scene = &scene;
    view.tree = &tree;
    view.boxes = node_boxes(tree);
    int again = 0;
    for (const Ray& ray : rays) {
        SetObserver seen;
        test_kernel::Kernel<SetObserver, traversal> kernel(view, seen);
        Hit hit = kernel.no_hit(ray);
        kernel.traverse(ray, false, hit);
        ASSERT_TRUE(seen.consistent) << test::hex(ray);
        again += seen.again_count;
    }
    EXPECT_EQ(again > 0, traversal != Traversal::stack);
}

TEST(Revisit, FlagMeansThatThisRayHasBeenThere) {
    const FlatScene scene = test::scene_of(test::random_soup(400, 0.05f, 21));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 3000, 6);
    check<Traversal::stack>(scene, tree, rays);
    check<Traversal::restart>(scene, tree, rays);
    check<Traversal::backtrack>(scene, tree, rays);
}

TEST(Revisit, HoldsOnLatticeScenes) {
    const FlatScene scene = test::scene_of(test::voxel_city(4));
    const KdTree tree = build_tree(scene.triangles, {});
    const std::vector<Ray> rays = test::unkind_rays(scene.triangles, 3000, 6);
    check<Traversal::stack>(scene, tree, rays);
    check<Traversal::restart>(scene, tree, rays);
    check<Traversal::backtrack>(scene, tree, rays);
}

}  // namespace
}  // namespace kd
