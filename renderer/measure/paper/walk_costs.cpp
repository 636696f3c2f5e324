#include "renderer/measure/paper/walk_costs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "renderer/measure/pixel_rays.h"

namespace kd {

namespace {

/// The shared text's rays and triangle test. Where asked for, it keeps the triangles whose corners it fetches.
class RayKernel {
  public:
    RayKernel(const FlatScene& scene, std::vector<int>* fetched)
        : corners_(scene.triangles.data()), bounds_(scene.bounds), fetched_(fetched) {}

#define KD_RULES KD_RULES_ROBUST
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#include "shaders/shared/triangle.glsl"
    // clang-format on
#undef KD_RULES

  protected:
    KD_FN void fetch_bounds(real3& lower, real3& upper) const {
        lower = bounds_.lower;
        upper = bounds_.upper;
    }

  private:
    KD_FN static bool masked_out(int, real, real) { return false; }
    KD_FN void fetch_corners(int, int triangle, int3 axes, real3& a, real3& b, real3& c) const {
        if (KD_RARE(fetched_ != nullptr)) fetched_->push_back(triangle);
        const float* p = &corners_[triangle].corner[0].x;
        a = real3(p[axes.x], p[axes.y], p[axes.z]);
        b = real3(p[3 + axes.x], p[3 + axes.y], p[3 + axes.z]);
        c = real3(p[6 + axes.x], p[6 + axes.y], p[6 + axes.z]);
    }

    const Triangle* corners_;
    Aabb bounds_;
    std::vector<int>* fetched_;
};

/// The shared text's stack traversal around it, with each test made once or twice.
template <TestsMade made>
class StackKernel : public RayKernel {
  public:
    StackKernel(const FlatScene& scene, const KdTree& tree, std::vector<int>* fetched)
        : RayKernel(scene, fetched), nodes_(tree.nodes.data()), references_(tree.references.data()) {}

    KD_FN void intersect_triangle(const RaySetup& s, int slot, int triangle, Hit& best) {
        if constexpr (made == TestsMade::twice) {
            Hit unused = best;
            int same = triangle;
            asm volatile("" : "+r"(same));  // no compiler may see that it is, nor that nobody looks at what it gives
            RayKernel::intersect_triangle(s, slot, same, unused);
            asm volatile("" : : "m"(unused));
        }
        RayKernel::intersect_triangle(s, slot, triangle, best);
    }

#define KD_STACK_SIZE max_tree_depth
#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_stack
#define KD_TEST_LEAF test_leaf
// Each uses the ones before it.
// clang-format off
#include "shaders/shared/split_rule.glsl"
#include "shaders/shared/leaf.glsl"
#include "shaders/shared/traverse_stack.glsl"
#include "shaders/shared/traverse.glsl"
    // clang-format on
#undef KD_TEST_LEAF
#undef KD_TRAVERSE
#undef KD_RULES
#undef KD_STACK_SIZE

  private:
    KD_FN KdNode fetch_node(int node) const {
        const TreeNode& n = nodes_[node];
        return {n.flag, n.split, n.count, n.link, n.parent};
    }
    KD_FN int entry_node() const { return 0; }
    void fetch_node_box(int, real3&, real3&) const {}  // only of entries that are not the root
    KD_FN int fetch_reference(int slot) const { return references_[slot]; }
    [[nodiscard]] int step_budget() const { return std::numeric_limits<int>::max() / 2; }
    void on_interior(int, bool) {}
    void on_leaf(int) {}
    void on_triangle(int) {}
    void on_push(int) {}
    void on_exit(int) {}

    const TreeNode* nodes_;
    const std::int32_t* references_;
};

template <TestsMade made>
void trace_all(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays, std::span<Hit> hits,
               std::vector<int>* fetched = nullptr) {
    StackKernel<made> kernel(scene, tree, fetched);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = {-1, rays[i].t_max, 0, 0};
        kernel.traverse(rays[i], false, hits[i]);
    }
}

}  // namespace

std::vector<int> tested_triangles(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays,
                                  TestsMade made) {
    std::vector<int> tested;
    std::vector<Hit> hits(rays.size());
    if (made == TestsMade::once)
        trace_all<TestsMade::once>(scene, tree, rays, hits, &tested);
    else
        trace_all<TestsMade::twice>(scene, tree, rays, hits, &tested);
    return tested;
}

PaperTriangleTests compare_tests(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera, int width,
                                 int height, int rounds, const std::stop_token& stop) {
    const std::vector<Ray> rays = pixel_rays(camera, width, height);
    std::vector<Hit> once(rays.size()), twice(rays.size());
    const auto timed = [&](auto trace) {
        return [&stop, trace] { return stop.stop_requested() ? TimeSample{} : TimeSample{wall_ms(trace)}; };
    };
    const std::vector<Contestant> contestants{
        {"tests made once", timed([&] { trace_all<TestsMade::once>(scene, tree, rays, once); })},
        {"tests made twice", timed([&] { trace_all<TestsMade::twice>(scene, tree, rays, twice); })}};
    std::vector<TimedRounds> rounds_of = time_in_turn(contestants, {.warmup = 1, .rounds = rounds});
    const bool same = std::ranges::equal(once, twice, [](const Hit& a, const Hit& b) { return bit_equal(a, b); });
    if (!same && !stop.stop_requested())
        throw std::logic_error("walks with triangle tests made once and twice do not find the same hits");
    return {"", std::move(rounds_of[0]), std::move(rounds_of[1])};
}

}  // namespace kd
