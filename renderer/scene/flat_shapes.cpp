#include "renderer/scene/flat_shapes.h"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace kd {

void add_patch(Mesh& mesh, Vec3 corner, Vec3 u, Vec3 v, int columns, int rows) {
    const auto first = std::uint32_t(mesh.positions.size());
    const auto stride = std::uint32_t(columns + 1);
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double s = double(column) / columns;
            const double t = double(row) / rows;
            mesh.positions.emplace_back(glm::dvec3(corner) + s * glm::dvec3(u) + t * glm::dvec3(v));
        }
    }
    for (std::uint32_t row = 0; row < std::uint32_t(rows); ++row) {
        for (std::uint32_t column = 0; column < std::uint32_t(columns); ++column) {
            const std::uint32_t a = first + row * stride + column;
            const std::uint32_t b = a + stride;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    }
}

void add_box(Mesh& mesh, const BoxShape& shape) {
    const glm::dvec3 centre = 0.5 * (glm::dvec3(shape.lower) + glm::dvec3(shape.upper));
    const glm::dvec3 half = 0.5 * (glm::dvec3(shape.upper) - glm::dvec3(shape.lower));
    const double angle = glm::radians(shape.turn_degrees);
    const glm::dvec3 x = half.x * glm::dvec3(std::cos(angle), 0.0, -std::sin(angle));
    const glm::dvec3 y = half.y * glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 z = half.z * glm::dvec3(std::sin(angle), 0.0, std::cos(angle));

    // Each face by its outward normal and the two edges that make it, with u x v outwards.
    struct Face {
        BoxFace name;
        glm::dvec3 out, u, v;
    };
    const Face faces[] = {{box_left, -x, z, y}, {box_right, x, -z, y}, {box_bottom, -y, x, z},
                          {box_top, y, x, -z},  {box_back, -z, -x, y}, {box_front, z, x, y}};
    for (Face face : faces) {
        if ((shape.faces & face.name) == 0) continue;
        if (shape.seen_from_inside) std::swap(face.u, face.v);
        const glm::dvec3 corner = centre + face.out - face.u - face.v;
        add_patch(mesh, Vec3(corner), Vec3(2.0 * face.u), Vec3(2.0 * face.v), shape.cells, shape.cells);
    }
}

}  // namespace kd
