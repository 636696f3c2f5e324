// The numbers behind glTF accessors.
#pragma once

#include <cstdint>
#include <tiny_gltf.h>
#include <vector>

#include "renderer/io/gltf_context.h"

namespace kd {

/// Every byte that any accessor, sparse or not, can touch lies within its bufferView; types and strides fit. InputError
/// with the JSON pointer of the value at fault. The readers below need this to have passed.
void check_accessors(const GltfContext& context, const tinygltf::Model& model);

/// Numbers of one element: 1 for SCALAR, 3 for VEC3, ...
[[nodiscard]] std::size_t component_count(const tinygltf::Accessor& accessor);

/// All numbers of an accessor in order, component_count() for each element. Integers become floats, normalised ones as
/// glTF 2.0, section 3.6.2.2 says; an accessor without a bufferView is zero where nothing sparse overrides it.
/// InputError where a sparse index is out of range.
[[nodiscard]] std::vector<float> read_floats(const GltfContext& context, const tinygltf::Model& model, int accessor);

/// The indices of a primitive, from 8, 16 or 32-bit unsigned SCALARs. InputError for any other type.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfContext& context, const tinygltf::Model& model,
                                                      int accessor);

}  // namespace kd
