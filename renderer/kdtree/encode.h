// The tree as the paper's texture: one RGBA32F texel per node (its section 2.3.1).
#pragma once

#include <vector>

#include "renderer/kdtree/tree.h"

namespace kd {

/// Texel: x = flag, y = split or count, z = link, w = parent. Float holds integers exactly up to 2^24, so larger
/// numbers are refused: InputError with the numbers.
[[nodiscard]] std::vector<Vec4> encode_float4(const KdTree& tree);
[[nodiscard]] KdTree decode_float4(const std::vector<Vec4>& texels, std::vector<std::int32_t> references,
                                   const Aabb& bounds);

/// Largest integer that a float texel addresses exactly.
inline constexpr std::int64_t float_index_limit = std::int64_t(1) << 24;

}  // namespace kd
