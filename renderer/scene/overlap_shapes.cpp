#include "renderer/scene/overlap_shapes.h"

#include <cmath>

namespace kd {

namespace {

/// Bits 4, 2, 1 of `c` choose the upper end in x, y, z.
Vec3 corner_of(const Aabb& box, int c) {
    return {c & 4 ? box.upper.x : box.lower.x, c & 2 ? box.upper.y : box.lower.y, c & 1 ? box.upper.z : box.lower.z};
}

}  // namespace

std::vector<Triangle> box_faces(const Aabb& box) {
    static constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                        {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    std::vector<Triangle> triangles;
    for (const auto& f : faces) {
        triangles.push_back({{corner_of(box, f[0]), corner_of(box, f[1]), corner_of(box, f[2])}});
        triangles.push_back({{corner_of(box, f[0]), corner_of(box, f[2]), corner_of(box, f[3])}});
    }
    return triangles;
}

std::vector<Triangle> cube_spanning(int n, float jitter, Random& random) {
    const Aabb cube{Vec3(0.0f), Vec3(1.0f)};
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) {
        const int start = int(random.next() % 8);
        // Neither the first corner nor the opposite one.
        const int third = (start + 1 + int(random.next() % 6)) % 8;
        const int by_way_of = third == 7 - start ? start ^ 1 : third;
        Triangle t{{corner_of(cube, start), corner_of(cube, 7 - start), corner_of(cube, by_way_of)}};
        for (Vec3& p : t.corner)
            for (int axis = 0; axis < 3; ++axis) {
                const auto inwards = float(random.between(0, jitter));
                p[axis] += p[axis] > 0.5f ? -inwards : inwards;
            }
        triangles.push_back(t);
    }
    return triangles;
}

std::vector<Triangle> random_boxes(int n, Random& random) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) {
        Aabb box;
        for (int corner = 0; corner < 2; ++corner) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = float(random.unit());
            box.include(p);
        }
        for (const Triangle& t : box_faces(box)) triangles.push_back(t);
    }
    return triangles;
}

std::vector<Triangle> vertex_fan(int n) {
    const auto rim = [n](int i) {
        const double angle = 2 * M_PI * (i % n) / n;
        return Vec3(float(std::cos(angle)), float(std::sin(angle)), 0.0f);
    };
    std::vector<Triangle> triangles;
    for (int i = 0; i < n; ++i) triangles.push_back({{Vec3(0, 0, 1), rim(i), rim(i + 1)}});
    return triangles;
}

std::vector<Triangle> terrain(int n, float height, Random& random) {
    std::vector<Vec3> points;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            points.emplace_back(float(i) / float(n), float(j) / float(n), float(random.between(0, height)));
    const auto point = [&](int i, int j) { return points[std::size_t(j) * std::size_t(n + 1) + std::size_t(i)]; };
    std::vector<Triangle> triangles;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            triangles.push_back({{point(i, j), point(i + 1, j), point(i + 1, j + 1)}});
            triangles.push_back({{point(i, j), point(i + 1, j + 1), point(i, j + 1)}});
        }
    return triangles;
}

}  // namespace kd
