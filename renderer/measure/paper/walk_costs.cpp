#include "renderer/measure/paper/walk_costs.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "renderer/geometry/input_error.h"
#include "renderer/measure/pixel_rays.h"

namespace kd {

namespace {

constexpr std::uint32_t most_packed = 1u << 30;

KD_FN KdNode unpacked(const TreeNode& n) { return {n.flag, n.split, n.count, n.link, n.parent}; }

KD_FN KdNode unpacked(const NarrowNode& n) {
    const int flag = int(n.packed & 3), rest = int(n.packed >> 2);
    return {flag, n.split, rest, flag == KD_LEAF ? int(n.first) : rest, -1};
}

/// Watch of a kernel that is timed: nobody is told.
struct NoWatch {
    KD_FN void operator()(int) const {}
};

/// Keeps the triangle of every test, in their order.
struct TestWatch {
    std::vector<int>* tested;
    void operator()(int triangle) const { tested->push_back(triangle); }
};

/// The shared text's stack traversal over nodes of either layout, with each triangle test made once or twice. `Watch`
/// is told of every test, where it fetches the triangle's corners.
template <class Node, TestsMade made = TestsMade::once, class Watch = NoWatch>
class NodeKernel {
  public:
    NodeKernel(const FlatScene& scene, const KdTree& tree, const Node* nodes, const Watch& watch = {})
        : nodes_(nodes), references_(tree.references.data()), corners_(scene.triangles.data()), bounds_(scene.bounds),
          watch_(watch) {}

#define KD_STACK_SIZE max_tree_depth
#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_stack
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#define intersect_triangle test_triangle
#include "shaders/shared/triangle.glsl"
#undef intersect_triangle
    KD_FN void intersect_triangle(const RaySetup& s, int slot, int triangle, Hit& best) {
        if constexpr (made == TestsMade::twice) {
            Hit unused = best;
            int same = triangle;
            asm volatile("" : "+r"(same));  // no compiler may see that it is, nor that nobody looks at what it gives
            test_triangle(s, slot, same, unused);
            asm volatile("" : : "m"(unused));
        }
        test_triangle(s, slot, triangle, best);
    }
#include "shaders/shared/split_rule.glsl"
#include "shaders/shared/leaf.glsl"
#include "shaders/shared/traverse_stack.glsl"
#include "shaders/shared/traverse.glsl"
    // clang-format on
#undef KD_TRAVERSE
#undef KD_RULES
#undef KD_STACK_SIZE

  private:
    KD_FN KdNode fetch_node(int node) const { return unpacked(nodes_[node]); }
    KD_FN int entry_node() const { return 0; }
    void fetch_node_box(int, real3&, real3&) const {}  // only of entries that are not the root
    KD_FN int fetch_reference(int slot) const { return references_[slot]; }
    KD_FN void fetch_bounds(real3& lower, real3& upper) const {
        lower = bounds_.lower;
        upper = bounds_.upper;
    }
    KD_FN void fetch_corners(int, int triangle, int3 axes, real3& a, real3& b, real3& c) const {
        watch_(triangle);
        const float* p = &corners_[triangle].corner[0].x;
        a = real3(p[axes.x], p[axes.y], p[axes.z]);
        b = real3(p[3 + axes.x], p[3 + axes.y], p[3 + axes.z]);
        c = real3(p[6 + axes.x], p[6 + axes.y], p[6 + axes.z]);
    }
    [[nodiscard]] int step_budget() const { return std::numeric_limits<int>::max() / 2; }
    void on_interior(int, bool) {}
    void on_leaf(int) {}
    void on_triangle(int) {}
    void on_push(int) {}
    void on_exit(int) {}

    const Node* nodes_;
    const std::int32_t* references_;
    const Triangle* corners_;
    Aabb bounds_;
    [[no_unique_address]] Watch watch_;
};

/// A way to trace all rays.
struct Walk {
    const char* name;
    std::function<void(std::span<Hit>)> trace;
};

template <TestsMade made = TestsMade::once, class Node, class Watch = NoWatch>
void trace_all(const FlatScene& scene, const KdTree& tree, const Node* nodes, std::span<const Ray> rays,
               std::span<Hit> hits, const Watch& watch = {}) {
    NodeKernel<Node, made, Watch> kernel(scene, tree, nodes, watch);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = {-1, rays[i].t_max, 0, 0};
        kernel.traverse(rays[i], false, hits[i]);
    }
}

}  // namespace

std::vector<NarrowNode> narrow_nodes(const KdTree& tree) {
    if (tree.nodes.size() >= most_packed || tree.references.size() >= most_packed)
        throw InputError("nodes of 8 bytes: the tree has more than 2^30 nodes or references; choose a smaller scene");
    std::vector<NarrowNode> nodes(tree.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const TreeNode& from = tree.nodes[i];
        if (from.is_leaf())
            nodes[i].first = std::uint32_t(from.link);
        else
            nodes[i].split = from.split;
        nodes[i].packed = std::uint32_t(from.flag) | std::uint32_t(from.is_leaf() ? from.count : from.link) << 2;
    }
    return nodes;
}

void trace_wide(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays, std::span<Hit> hits) {
    trace_all(scene, tree, tree.nodes.data(), rays, hits);
}

void trace_narrow(const FlatScene& scene, const KdTree& tree, std::span<const NarrowNode> nodes,
                  std::span<const Ray> rays, std::span<Hit> hits) {
    trace_all(scene, tree, nodes.data(), rays, hits);
}

std::vector<int> tested_triangles(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays,
                                  TestsMade made) {
    std::vector<int> tested;
    std::vector<Hit> hits(rays.size());
    const TestWatch watch{&tested};
    if (made == TestsMade::once)
        trace_all(scene, tree, tree.nodes.data(), rays, hits, watch);
    else
        trace_all<TestsMade::twice>(scene, tree, tree.nodes.data(), rays, hits, watch);
    return tested;
}

namespace {

/// Both in turn; they must find the same hits in every bit.
std::array<TimedRounds, 2> time_both(std::size_t rays, int rounds, const std::stop_token& stop,
                                     const std::array<Walk, 2>& walks) {
    std::array<std::vector<Hit>, 2> hits{std::vector<Hit>(rays), std::vector<Hit>(rays)};
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < 2; ++i)
        contestants.push_back({walks[i].name, [&, i] {
                                   if (stop.stop_requested()) return TimeSample{};
                                   return TimeSample{wall_ms([&] { walks[i].trace(hits[i]); })};
                               }});
    std::vector<TimedRounds> timed = time_in_turn(contestants, {.warmup = 1, .rounds = rounds});
    const bool same = std::ranges::equal(hits[0], hits[1], [](const Hit& a, const Hit& b) { return bit_equal(a, b); });
    if (!same && !stop.stop_requested())
        throw std::logic_error(std::string("walks by ") + walks[0].name + " and " + walks[1].name +
                               " do not find the same hits");
    return {std::move(timed[0]), std::move(timed[1])};
}

}  // namespace

PaperNodeSizes compare_nodes(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera, int width,
                             int height, int rounds, const std::stop_token& stop) {
    const std::vector<Ray> rays = pixel_rays(camera, width, height);
    const std::vector<NarrowNode> nodes = narrow_nodes(tree);
    auto [wide, narrow] = time_both(
        rays.size(), rounds, stop,
        {Walk{"nodes of 16 bytes", [&](std::span<Hit> hits) { trace_wide(scene, tree, rays, hits); }},
         Walk{"nodes of 8 bytes", [&](std::span<Hit> hits) { trace_narrow(scene, tree, nodes, rays, hits); }}});
    return {"", tree.nodes.size(), std::move(wide), std::move(narrow)};
}

PaperTriangleTests compare_tests(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera, int width,
                                 int height, int rounds, const std::stop_token& stop) {
    const std::vector<Ray> rays = pixel_rays(camera, width, height);
    auto [once, twice] =
        time_both(rays.size(), rounds, stop,
                  {Walk{"tests made once", [&](std::span<Hit> hits) { trace_wide(scene, tree, rays, hits); }},
                   Walk{"tests made twice", [&](std::span<Hit> hits) {
                            trace_all<TestsMade::twice>(scene, tree, tree.nodes.data(), rays, hits);
                        }}});
    return {"", std::move(once), std::move(twice)};
}

}  // namespace kd
