// Small scenes and unkind rays for tests. Deterministic for a seed.
#pragma once

#include <vector>

#include "renderer/scene/stress_shapes.h"

namespace kd::test {

/// The project's random numbers in the shapes that tests use.
class Random : public kd::Random {
  public:
    using kd::Random::Random;
    [[nodiscard]] float uniform(float low, float high);
    [[nodiscard]] int below(int n);
    [[nodiscard]] Vec3 point(float low, float high);
};

[[nodiscard]] inline FlatScene scene_of(std::vector<Triangle> triangles) { return bare_scene(std::move(triangles)); }

[[nodiscard]] inline std::vector<Triangle> random_soup(int n, float size, unsigned seed) {
    Random random(seed);
    return kd::random_soup(n, size, random);
}

using kd::stress_sphere;
using kd::voxel_city;

/// Soup, mirror floor, smooth-normal sphere and two lights: every pass and ray type has work.
[[nodiscard]] FlatScene mirror_scene(int soup_triangles, unsigned seed);
/// The same with lights of every kind that have a radius, and rough mirrors: all that can be sampled.
[[nodiscard]] FlatScene soft_scene(int n, unsigned seed);

/// Rays towards vertices, edges and interiors, axis-parallel with both zeros, inside coordinate planes, from vertices.
[[nodiscard]] std::vector<Ray> unkind_rays(const std::vector<Triangle>& triangles, int n, unsigned seed);

/// "o=(0x1.8p+0, ...) d=(...)" so that a failing ray can be repeated exactly.
[[nodiscard]] std::string hex(const Ray& ray);

}  // namespace kd::test
