// The rays that tracers are compared on: the same arrays for all.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"

namespace kd {

enum class RayType { primary, shadow, random };
inline constexpr std::array<std::string_view, 3> ray_type_names{"primary", "shadow", "random"};

struct BenchRays {
    RayType type = RayType::primary;
    std::vector<Ray> rays;

    [[nodiscard]] bool any_hit() const { return type == RayType::shadow; }
    /// Neighbours go alike.
    [[nodiscard]] bool coherent() const { return type != RayType::random; }
};

/// A ray for every pixel along a Morton curve (Morton 1966), on which each 2^n x 2^n pixels are together: packets of
/// any power of two are tiles.
[[nodiscard]] std::vector<Ray> morton_rays(const PinholeCamera& camera, int width, int height);

/// Of each type, in their order: primary ones of the scene's camera; from their hits towards the scene's first light,
/// up to it; and from there in directions uniform over the hemisphere about the geometric normal, as long as rays may
/// be; these begin at t = 1e-4 of the scene's diagonal, and know no triangle to pass over. Types that there are no rays
/// of, as the scene has no light or the picture no hit, are left out.
[[nodiscard]] std::vector<BenchRays> bench_rays(const FlatScene& scene, const KdTree& tree, int width, int height,
                                                unsigned seed);

}  // namespace kd
