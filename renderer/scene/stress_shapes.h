// Triangles that are hard on ray tracers, for the stability suite and the tests. Deterministic.
#pragma once

#include <vector>

#include "renderer/scene/random.h"
#include "renderer/scene/scene.h"

namespace kd {

/// A flat scene of these triangles, all of them, in internal units (units.h): one grey material, one light, geometric
/// normals, a fitted camera.
[[nodiscard]] FlatScene bare_scene(std::vector<Triangle> triangles);

/// A point with each coordinate in [low, high).
[[nodiscard]] Vec3 random_point(Random& random, float low, float high);

/// n triangles with corners within `size` of a random point of the unit cube.
[[nodiscard]] std::vector<Triangle> random_soup(int n, float size, Random& random);

/// Closed sphere of 2 * columns * (rows - 1) triangles around `centre`.
[[nodiscard]] std::vector<Triangle> stress_sphere(int columns, int rows, float radius = 1.0f, Vec3 centre = Vec3(0.0f));

/// Axis-aligned unit cubes on an integer lattice, those with (7x + 13y + 5z) % 3 == 0 of n^3, 12 triangles each.
[[nodiscard]] std::vector<Triangle> voxel_city(int n);

/// The rectangle spanned by u and v at `corner`, in columns x rows cells of two triangles.
[[nodiscard]] std::vector<Triangle> grid(Vec3 corner, Vec3 u, Vec3 v, int columns, int rows);

/// Each coordinate times `factor`.
[[nodiscard]] std::vector<Triangle> scaled(std::vector<Triangle> triangles, float factor);

}  // namespace kd
