// What the triangle tests of a walk cost (paper, section 2.3.1), whose rest is traversal.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/measure/paper/paper_results.h"
#include "renderer/scene/scene.h"

namespace kd {

/// How often a walk tests a triangle that it meets.
enum class TestsMade { once, twice };

/// The triangles of all tests of the stack traversal, in their order.
[[nodiscard]] std::vector<int> tested_triangles(const FlatScene& scene, const KdTree& tree, std::span<const Ray> rays,
                                                TestsMade made);

/// Times the stack traversal of a picture's primary rays on one thread with every triangle tested once against twice,
/// in turn; the difference is what the tests cost. The second test of a triangle finds it in the cache, so they cost a
/// little more. std::logic_error where hits differ in a bit: a fault of the program, whatever the scene.
[[nodiscard]] PaperTriangleTests compare_tests(const FlatScene& scene, const KdTree& tree, const PinholeCamera& camera,
                                               int width, int height, int rounds, const std::stop_token& stop);

}  // namespace kd
