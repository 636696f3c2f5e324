#include "renderer/measure/error_time/walks.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/kdtree/ropes.h"
#include "renderer/trace/observer.h"

namespace kd {

inline namespace f32 {
namespace {
#include "renderer/measure/error_time/walks.inc"

#define KD_WALK_KERNEL PassingKernel
#define KD_TRIANGLE_TEST "renderer/measure/error_time/no_test.inc"
#include "renderer/measure/error_time/walk_kernel.inc"
#undef KD_TRIANGLE_TEST
#undef KD_WALK_KERNEL
}  // namespace
}  // namespace f32

namespace f64 {
/// walks_double.cpp.
void walk_in_double(const WalkScene& scene, const HitMethod& method, std::span<const kd::Ray> rays,
                    std::span<HitAnswer> answers);
}  // namespace f64

std::string HitMethod::family_name() const {
    return fmt::format("{}, {}, {}", triangle_test_names[std::size_t(test)], in_double ? "double" : "float",
                       info(rules).name);
}

WalkScene::WalkScene(const FlatScene& scene, const KdTree& tree)
    : nodes(tree.nodes.data()), references(tree.references.data()), triangles(scene.triangles.data()),
      triangle_count(int(scene.triangles.size())), bounds(scene.bounds), boxes(node_boxes(tree)),
      ropes(make_ropes(tree, TraceConfig{}.optimised_ropes)) {}

void walk_rays(const WalkScene& scene, const HitMethod& method, std::span<const Ray> rays,
               std::span<HitAnswer> answers) {
    if (method.in_double)
        f64::walk_in_double(scene, method, rays, answers);
    else
        walk(scene, method, rays, answers);
}

double PassedCells::standard_error() const {
    if (rays < 2) return 0;
    const double n = double(rays);
    return std::sqrt(std::max(0.0, cost_squared / n - mean_cost() * mean_cost()) / (n - 1));
}

PassedCells pass_cells(const WalkScene& scene, std::span<const Ray> rays, double traversal_cost,
                       double intersection_cost) {
    PassedCells sum;
    CountingObserver seen;
    PassingKernel<CountingObserver, Rules::robust> kernel(scene, Traversal::stack, seen);
    for (const Ray& ray : rays) {
        seen.counters = {};
        Hit hit = kernel.no_hit(ray);
        kernel.traverse(ray, false, hit);
        const RayCounters& c = seen.counters;
        const double cost = traversal_cost * c.interior_first + intersection_cost * c.triangle_tests;
        ++sum.rays;
        sum.interior += c.interior_first;
        sum.leaves += c.leaves;
        sum.tests += c.triangle_tests;
        sum.cost += cost;
        sum.cost_squared += cost * cost;
    }
    return sum;
}

}  // namespace kd
