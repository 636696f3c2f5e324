// What tracing can do without where a scene does not ask for it, and sets of such things.
#pragma once

#include <cstdint>

namespace kd {

/// The table of features() in renderer/scene/needs.h has a row for each, in this order.
enum class Feature {
    reflections,
    later_bounces,
    shadows,
    many_lights,
    directional_lights,
    placed_lights,
    spot_lights,
    highlights,
    emission,
    soft_shadows,
    gloss,
    indirect,
    textures,
    mip_maps,
    wraps,
    normal_maps,
    masks,
    normals,
    material_numbers,
    wide_references,
    deep_tree,
    wide_nodes,
    node_boxes,
    ropes,
    leaf_copies,
    counters,
    exact_products,
};

/// A set of features, empty at first.
class FeatureSet {
  public:
    constexpr FeatureSet() = default;
    constexpr FeatureSet(Feature only) : bits_(bit(only)) {}

    [[nodiscard]] constexpr bool has(Feature feature) const { return (bits_ & bit(feature)) != 0; }
    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
    constexpr void set(Feature feature, bool in) { bits_ = in ? bits_ | bit(feature) : bits_ & ~bit(feature); }
    [[nodiscard]] constexpr FeatureSet with(Feature feature) const {
        FeatureSet more = *this;
        more.set(feature, true);
        return more;
    }

    bool operator==(const FeatureSet&) const = default;

  private:
    static constexpr std::uint32_t bit(Feature feature) { return std::uint32_t(1) << static_cast<unsigned>(feature); }
    std::uint32_t bits_ = 0;
};

}  // namespace kd
