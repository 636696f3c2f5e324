// What the parts of a walk cost (paper, section 2.3.1): nodes of 16 against 8 bytes, and the triangle tests, whose rest
// is traversal.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/measure/paper/paper_results.h"
#include "renderer/scene/scene.h"

namespace kd {

/// The layout of "Physically Based Rendering": no parent, and the kind of node in two bits that the link has to spare.
struct NarrowNode {
    union {
        float split;          // interior: plane position
        std::uint32_t first;  // leaf: first reference
    };
    std::uint32_t packed;  // 2 bits: split axis or KD_LEAF; 30 bits: child above, or number of references
};
static_assert(sizeof(NarrowNode) == 8);

/// The tree's nodes in that layout, in the same order. InputError above 2^30 nodes or references in a leaf.
[[nodiscard]] std::vector<NarrowNode> narrow_nodes(const KdTree& tree);

/// Nearest hits by the stack traversal over either layout, on one thread.
void trace_wide(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays, std::span<Hit> hits);
void trace_narrow(const FlatScene& scene, const KdTree& tree, std::span<const NarrowNode> nodes,
                  std::span<const Ray> rays, std::span<Hit> hits);

/// How often a walk tests a triangle that it meets.
enum class TestsMade { once, twice };

/// The triangles of all tests of the walk over nodes of 16 bytes, in their order.
[[nodiscard]] std::vector<int> tested_triangles(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays,
                                                TestsMade made);

/// Times both in turn on the primary rays of a picture. std::logic_error where their hits differ in a bit: a fault of
/// the program, whatever the scene.
[[nodiscard]] PaperNodeSizes compare_nodes(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera,
                                           int width, int height, int rounds, const std::stop_token& stop);

/// Times the walk over nodes of 16 bytes with every triangle tested once against twice, whose difference is what the
/// tests cost. The second test of a triangle finds it in the cache, so they cost a little more. Throws as above.
[[nodiscard]] PaperTriangleTests compare_tests(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera,
                                               int width, int height, int rounds, const std::stop_token& stop);

}  // namespace kd
