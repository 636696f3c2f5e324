#include "renderer/kdtree/validate.h"

#include <cmath>
#include <fmt/format.h>

#include "renderer/kdtree/coverage.h"
#include "renderer/kdtree/findings.h"

namespace kd {

namespace {

bool overlap(const Aabb& a, const Aabb& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(a.lower[axis] <= b.upper[axis] && b.lower[axis] <= a.upper[axis])) return false;
    }
    return true;
}

bool contains(const Aabb& outer, const Aabb& inner) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(outer.lower[axis] <= inner.lower[axis] && inner.upper[axis] <= outer.upper[axis])) return false;
    }
    return true;
}

/// A node about to be visited, with what its parent says of it.
struct Visit {
    int node;
    int parent;
    bool is_above;
    int depth;
    Aabb cell;
};

/// Walks a tree that may hold anything, entering each node at most once.
class Walk {
  public:
    Walk(const KdTree& tree, std::span<const Triangle> triangles, Findings& findings)
        : tree_(tree), triangles_(triangles), findings_(findings), reached_(tree.nodes.size(), false),
          claimed_(tree.references.size(), false), last_leaf_(triangles.size(), -1) {}

    void run() {
        if (tree_.nodes.empty()) {
            findings_.add(-1, "tree has no node: it needs a root");
            return;
        }
        pending_.push_back({0, -1, false, 0, tree_.bounds});
        while (!pending_.empty() && !findings_.full()) {
            const Visit at = pending_.back();
            pending_.pop_back();
            enter(at);
        }
        report_left_over();
    }

  private:
    int node_count() const { return int(tree_.nodes.size()); }

    void enter(const Visit& at) {
        if (reached_[std::size_t(at.node)]) {
            findings_.add(at.node, fmt::format("reached a second time, as a child of node {}", at.parent));
            return;
        }
        reached_[std::size_t(at.node)] = true;
        if (at.is_above && at.node != last_ + 1) {
            findings_.add(at.parent, fmt::format("link to the child above is {}, depth-first order asks for {}",
                                                 at.node, last_ + 1));
        }
        last_ = at.node;

        const TreeNode& node = tree_.nodes[std::size_t(at.node)];
        if (node.parent != at.parent) {
            findings_.add(at.node, fmt::format("parent link is {} instead of {}", node.parent, at.parent));
        }
        if (at.depth > max_tree_depth) {
            findings_.add(at.node, fmt::format("stands at depth {}, beyond {}", at.depth, max_tree_depth));
        }
        if (node.is_leaf())
            check_leaf(at, node);
        else if (node.flag >= 0 && node.flag <= 2)
            check_interior(at, node);
        else
            findings_.add(at.node, fmt::format("flag {} is none of 0, 1, 2 (split axis) and 3 (leaf)", node.flag));
    }

    void check_interior(const Visit& at, const TreeNode& node) {
        const float lower = at.cell.lower[node.flag];
        const float upper = at.cell.upper[node.flag];
        Visit below{at.node + 1, at.node, false, at.depth + 1, at.cell};
        Visit above{node.link, at.node, true, at.depth + 1, at.cell};
        if (std::isfinite(node.split) && lower < node.split && node.split < upper) {
            below.cell.upper[node.flag] = node.split;
            above.cell.lower[node.flag] = node.split;
        } else {
            findings_.add(at.node, fmt::format("split at {} is not strictly inside its cell, {} to {} on axis {}",
                                               node.split, lower, upper, node.flag));
        }
        if (node.link > at.node + 1 && node.link < node_count())
            pending_.push_back(above);
        else
            findings_.add(at.node, fmt::format("link to the child above is {}, outside {}..{}", node.link, at.node + 2,
                                               node_count() - 1));
        if (at.node + 1 < node_count())
            pending_.push_back(below);
        else
            findings_.add(at.node, "child below is missing: the last node must be a leaf");
    }

    void check_leaf(const Visit& at, const TreeNode& leaf) {
        const std::int64_t end = std::int64_t(leaf.link) + leaf.count;
        if (leaf.count < 0 || leaf.link < 0 || end > std::int64_t(tree_.references.size())) {
            findings_.add(at.node, fmt::format("leaf list of {} from {} is outside the {} references", leaf.count,
                                               leaf.link, tree_.references.size()));
            return;
        }
        for (std::size_t slot = std::size_t(leaf.link); slot < std::size_t(end) && !findings_.full(); ++slot) {
            if (claimed_[slot]) findings_.add(at.node, fmt::format("leaf list shares reference {} with another", slot));
            claimed_[slot] = true;
            check_reference(at, tree_.references[slot]);
        }
    }

    void check_reference(const Visit& at, std::int32_t triangle) {
        if (triangle < 0 || std::size_t(triangle) >= triangles_.size()) {
            findings_.add(at.node, fmt::format("leaf names triangle {} of {}", triangle, triangles_.size()));
            return;
        }
        int& last = last_leaf_[std::size_t(triangle)];
        if (last == at.node) findings_.add(at.node, fmt::format("leaf names triangle {} twice", triangle));
        last = at.node;
        if (!overlap(bounds_of(triangles_[std::size_t(triangle)]), at.cell)) {
            findings_.add(at.node, fmt::format("leaf names triangle {}, which does not touch its cell", triangle));
        }
    }

    void report_left_over() {
        for (std::size_t i = 0; i < reached_.size() && !findings_.full(); ++i) {
            if (!reached_[i]) findings_.add(int(i), "cannot be reached from the root");
        }
        for (std::size_t i = 0; i < claimed_.size() && !findings_.full(); ++i) {
            if (!claimed_[i]) findings_.add(-1, fmt::format("reference {} belongs to no leaf", i));
        }
    }

    const KdTree& tree_;
    std::span<const Triangle> triangles_;
    Findings& findings_;
    std::vector<Visit> pending_;
    std::vector<bool> reached_;   // by node
    std::vector<bool> claimed_;   // by reference
    std::vector<int> last_leaf_;  // by triangle: the last leaf that named it
    int last_ = -1;               // node entered last
};

void check_bounds(const KdTree& tree, std::span<const Triangle> triangles, Findings& findings) {
    for (std::size_t t = 0; t < triangles.size() && !findings.full(); ++t) {
        if (!contains(tree.bounds, bounds_of(triangles[t]))) {
            findings.add(-1, fmt::format("triangle {} reaches beyond the bounds of the tree", t));
        }
    }
}

}  // namespace

std::vector<Violation> validate(const KdTree& tree, std::span<const Triangle> triangles, std::size_t limit) {
    Findings findings(limit);
    check_bounds(tree, triangles, findings);
    Walk(tree, triangles, findings).run();
    if (findings.none() && !findings.full()) check_coverage(tree, triangles, findings);
    return findings.take();
}

}  // namespace kd
