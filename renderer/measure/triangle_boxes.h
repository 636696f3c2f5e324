// Boxes around boxes around triangles: lets the double-precision oracle pass over what a ray comes nowhere near.
//
// It has nothing in common with the kd-trees that the oracle judges, so it does not share their faults.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "renderer/geometry/aabb.h"
#include "renderer/geometry/triangle.h"

namespace kd {

class TriangleBoxes {
  public:
    explicit TriangleBoxes(std::span<const Triangle> triangles);

    /// Calls `test(triangle)` for every triangle whose box, widened by `slack`, origin + t*direction meets at a t below
    /// `limit()`, nearer boxes first. `inverse` is 1/direction, and 0 on an axis along which the ray does not get away
    /// from its origin by as much as `slack` within the scene. `limit` is asked anew for each box.
    template <class Test, class Limit>
    void visit(const f64::real3& origin, const f64::real3& inverse, double slack, const Limit& limit,
               const Test& test) const;

  private:
    /// Both children lie below: the first is the next node, the other at `second`. A leaf has second = 0.
    struct Node {
        Aabb box;
        int first = 0, count = 0;  // triangles of the leaf, in order_
        int second = 0;
    };
    static constexpr int most_in_leaf = 4;
    static constexpr int most_levels = 64;  // of halves of less than 2^31 triangles

    void grow(std::span<const Triangle> triangles, int first, int count);

    std::vector<Node> nodes_;
    std::vector<int> order_;
};

/// Where a line enters `box` widened by `slack`, 0 where it starts inside; infinite where it passes by.
[[nodiscard]] double entry_into(const Aabb& box, const f64::real3& origin, const f64::real3& inverse, double slack);

template <class Test, class Limit>
void TriangleBoxes::visit(const f64::real3& origin, const f64::real3& inverse, double slack, const Limit& limit,
                          const Test& test) const {
    struct Waiting {
        int node;
        double entry;
    };
    Waiting stack[most_levels];
    int waiting = 0;
    if (!nodes_.empty()) stack[waiting++] = {0, entry_into(nodes_[0].box, origin, inverse, slack)};
    while (waiting > 0) {
        const Waiting top = stack[--waiting];
        if (!(top.entry <= limit())) continue;
        const Node& node = nodes_[std::size_t(top.node)];
        if (node.second == 0) {
            for (int i = 0; i < node.count; ++i) test(order_[std::size_t(node.first + i)]);
            continue;
        }
        Waiting near{top.node + 1, 0}, far{node.second, 0};
        near.entry = entry_into(nodes_[std::size_t(near.node)].box, origin, inverse, slack);
        far.entry = entry_into(nodes_[std::size_t(far.node)].box, origin, inverse, slack);
        if (far.entry < near.entry) std::swap(near, far);
        stack[waiting++] = far;
        stack[waiting++] = near;
    }
}

}  // namespace kd
