// Shapes with flat faces, appended to a mesh. Vertices are shared within a face only.
#pragma once

#include "renderer/scene/scene.h"

namespace kd {

/// A parallelogram from `corner` along `u` and `v`, in columns x rows cells of two triangles; seen from the side that
/// u x v points to.
void add_patch(Mesh& mesh, Vec3 corner, Vec3 u, Vec3 v, int columns = 1, int rows = 1);

/// Faces of a box, combined with |.
enum BoxFace : unsigned { box_left = 1, box_right = 2, box_bottom = 4, box_top = 8, box_back = 16, box_front = 32 };
inline constexpr unsigned all_box_faces = 63;

/// Left to right is x, bottom to top y, back to front z, before the box is turned about the vertical through its
/// centre.
struct BoxShape {
    Vec3 lower{0.0f};
    Vec3 upper{1.0f};
    double turn_degrees = 0.0;
    int cells = 1;  // along each edge of each face
    bool seen_from_inside = false;
    unsigned faces = all_box_faces;
};

void add_box(Mesh& mesh, const BoxShape& shape);

}  // namespace kd
