#include "renderer/measure/paper/node_sizes.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

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

/// The shared text's stack traversal over nodes of either layout; counts nothing.
template <class Node>
class NodeKernel {
  public:
    NodeKernel(const FlatScene& scene, const KdTree& tree, const Node* nodes)
        : nodes_(nodes), references_(tree.references.data()), corners_(scene.triangles.data()), bounds_(scene.bounds) {}

#define KD_STACK_SIZE max_tree_depth
#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_stack
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#include "shaders/shared/triangle.glsl"
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
};

template <class Node>
void trace_all(const FlatScene& scene, const KdTree& tree, const Node* nodes, std::span<const Ray> rays,
               std::span<Hit> hits) {
    NodeKernel<Node> kernel(scene, tree, nodes);
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

PaperNodeSizes compare_nodes(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera, int width,
                             int height, int rounds, const std::stop_token& stop) {
    const std::vector<Ray> rays = pixel_rays(camera, width, height);
    const std::vector<NarrowNode> nodes = narrow_nodes(tree);
    std::vector<Hit> wide(rays.size()), narrow(rays.size());
    const std::vector<Contestant> contestants{
        {"16 bytes",
         [&] {
             if (stop.stop_requested()) return TimeSample{};
             return TimeSample{wall_ms([&] { trace_wide(scene, tree, rays, wide); })};
         }},
        {"8 bytes", [&] {
             if (stop.stop_requested()) return TimeSample{};
             return TimeSample{wall_ms([&] { trace_narrow(scene, tree, nodes, rays, narrow); })};
         }}};
    std::vector<TimedRounds> timed = time_in_turn(contestants, {.warmup = 1, .rounds = rounds});
    const bool same = std::ranges::equal(wide, narrow, [](const Hit& a, const Hit& b) { return bit_equal(a, b); });
    if (!same && !stop.stop_requested())
        throw std::logic_error("nodes of 8 bytes: a hit differs from that with nodes of 16 bytes");
    return {"", tree.nodes.size(), std::move(timed[0]), std::move(timed[1])};
}

}  // namespace kd
