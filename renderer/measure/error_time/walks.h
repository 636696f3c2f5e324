// Walks through a tree that differ in triangle test, rules, traversal and precision, and in nothing else: what hit
// errors and their price are compared with. All compiled alike, for the plain processor.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rules.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// kdscope's own, watertight, after Woop, Benthin and Wald 2013; and that of Moeller and Trumbore 1997.
enum class TriangleTest { woop, moeller_trumbore };
inline constexpr std::array<std::string_view, 2> triangle_test_names{"watertight", "Moeller-Trumbore"};

struct HitMethod {
    TriangleTest test = TriangleTest::woop;
    bool in_double = false;
    Rules rules = Rules::robust;  // or as_published
    Traversal traversal = Traversal::stack;

    /// "watertight, double, as-published"; the traversal is not in it.
    [[nodiscard]] std::string family_name() const;
    /// What the watertight test and the robust rules promise together.
    [[nodiscard]] bool loses_nothing() const { return test == TriangleTest::woop && rules == Rules::robust; }
    bool operator==(const HitMethod&) const = default;
};

struct HitAnswer {
    int triangle = -1;
    double t = 0;
    bool operator==(const HitAnswer&) const = default;
};

/// A scene as the walks read it. What it was made from must outlive it.
struct WalkScene {
    WalkScene(const FlatScene& scene, const KdTree& tree);
    const TreeNode* nodes;
    const std::int32_t* references;
    const Triangle* triangles;
    int triangle_count;
    Aabb bounds;
    std::vector<Aabb> boxes;          // of the nodes
    std::vector<std::int32_t> ropes;  // the default's
};

/// Nearest hits on this thread.
void walk_rays(const WalkScene& scene, const HitMethod& method, std::span<const Ray> rays,
               std::span<HitAnswer> answers);

/// What rays that nothing stops meet in the tree; sums over the rays, and of squares for their spread.
struct PassedCells {
    std::int64_t rays = 0;
    double interior = 0, leaves = 0, tests = 0;
    double cost = 0, cost_squared = 0;  // traversal_cost * interior + intersection_cost * tests, per ray

    [[nodiscard]] double mean_cost() const { return rays > 0 ? cost / double(rays) : 0; }
    /// Of the mean.
    [[nodiscard]] double standard_error() const;
};

/// Walks through every cell on each ray's way, on this thread.
[[nodiscard]] PassedCells pass_cells(const WalkScene& scene, std::span<const Ray> rays, double traversal_cost,
                                     double intersection_cost);

}  // namespace kd
