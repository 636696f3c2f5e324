// Where in a pixel its samples lie: offsets of the whole camera, so that every tracer can trace them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "renderer/geometry/shared_types.h"

namespace kd {

/// `regular`: the middles of a grid of cells; `stratified`: one at random in each cell of that grid; `independent`:
/// each at random in the pixel.
enum class Sampler { regular, independent, stratified };
inline constexpr std::array<std::string_view, 3> sampler_names{"regular", "independent", "stratified"};
[[nodiscard]] inline std::string_view name_of(Sampler sampler) { return sampler_names[std::size_t(sampler)]; }

/// `count` offsets from the pixel's middle in pixels, x to the right and y down, each in [-0.5, 0.5). The grid of the
/// first two has the squarest shape that `count` cells allow, no higher than wide. The first k of independent offsets
/// are those of count k.
[[nodiscard]] std::vector<glm::dvec2> sample_offsets(Sampler sampler, int count, std::uint64_t seed);

/// The camera whose pixels' middles lie `offset` pixels off this one's.
[[nodiscard]] PinholeCamera shifted(const PinholeCamera& camera, glm::dvec2 offset, int width, int height);

}  // namespace kd
