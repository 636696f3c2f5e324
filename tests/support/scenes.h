// Small scenes and unkind rays for tests. Deterministic for a seed.
#pragma once

#include <vector>

#include "renderer/scene/scene.h"

namespace kd::test {

/// Deterministic numbers (PCG, O'Neill 2014), the same with every standard library.
class Random {
  public:
    explicit Random(unsigned seed) : state_(seed * 2654435769u + 1u) {}
    [[nodiscard]] std::uint32_t bits();
    [[nodiscard]] float uniform(float low, float high);
    [[nodiscard]] int below(int n);
    [[nodiscard]] Vec3 point(float low, float high);

  private:
    std::uint64_t state_;
};

/// A flat scene of these triangles: one grey material, one light, geometric normals.
[[nodiscard]] FlatScene scene_of(std::vector<Triangle> triangles);

/// n triangles with corners within `size` of a random point of the unit cube.
[[nodiscard]] std::vector<Triangle> random_soup(int n, float size, unsigned seed);

/// Closed unit sphere of 2 * columns * (rows - 1) triangles around `centre`.
[[nodiscard]] std::vector<Triangle> sphere(int columns, int rows, float radius = 1.0f, Vec3 centre = Vec3(0.0f));

/// Axis-aligned unit cubes on an integer lattice, those with (7x + 13y + 5z) % 3 == 0 of n^3, 12 triangles each.
[[nodiscard]] std::vector<Triangle> voxel_city(int n);

/// Soup, mirror floor, smooth-normal sphere and two lights: every pass and ray type has work.
[[nodiscard]] FlatScene mirror_scene(int soup_triangles, unsigned seed);

/// Rays towards vertices, edges and interiors, axis-parallel with both zeros, inside coordinate planes, from vertices.
[[nodiscard]] std::vector<Ray> unkind_rays(const std::vector<Triangle>& triangles, int n, unsigned seed);

/// "o=(0x1.8p+0, ...) d=(...)" so that a failing ray can be repeated exactly.
[[nodiscard]] std::string hex(const Ray& ray);

}  // namespace kd::test
