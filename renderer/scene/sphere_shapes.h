// Two tessellations of the sphere, with smooth normals: closed, consistently wound, every vertex shared.
#pragma once

#include "renderer/scene/scene.h"

namespace kd {

/// Meridians and parallels. `segments` (at least 3) around, `rings` (at least 2) from pole to pole.
struct UvTessellation {
    int segments = 3;
    int rings = 2;
    [[nodiscard]] int triangles() const { return 2 * segments * (rings - 1); }
};

/// The tessellation whose number of triangles is nearest to `wanted`, among those with 1.5 to 2.5 segments per ring.
[[nodiscard]] UvTessellation uv_tessellation(int wanted);

/// The frequency n (at least 1) whose 20 n^2 triangles are nearest to `wanted`.
[[nodiscard]] int icosphere_frequency(int wanted);

/// Appended to `mesh`, which must have a normal for every position.
void add_uv_sphere(Mesh& mesh, Vec3 centre, double radius, UvTessellation tessellation);

/// The icosahedron with every edge cut into `frequency` parts and all points moved onto the sphere; it has no poles.
void add_icosphere(Mesh& mesh, Vec3 centre, double radius, int frequency);

}  // namespace kd
