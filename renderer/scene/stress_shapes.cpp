#include "renderer/scene/stress_shapes.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/scene/overlap_shapes.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/units.h"

namespace kd {

Vec3 random_point(Random& random, float low, float high) {
    const auto x = float(random.between(low, high));
    const auto y = float(random.between(low, high));
    return {x, y, float(random.between(low, high))};
}

FlatScene bare_scene(std::vector<Triangle> triangles) {
    FlatScene scene;
    scene.name = "bare";
    for (const Triangle& t : triangles) {
        const Vec3 cross = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
        const Vec3 normal = glm::dot(cross, cross) > 0 ? glm::normalize(cross) : Vec3(0, 0, 1);
        scene.attributes.push_back({{normal, normal, normal}, {}, 0});
        for (const Vec3& p : t.corner) scene.bounds.include(p);
    }
    scene.triangles = std::move(triangles);
    rescale(scene);
    scene.materials = {default_material()};
    scene.camera = fit_camera(scene.bounds);
    scene.lights = {default_light(scene.camera)};
    scene.ambient = Vec3(0.1f);
    scene.background = Vec3(0.05f, 0.06f, 0.08f);
    return scene;
}

std::vector<Triangle> random_soup(int n, float size, Random& random) {
    std::vector<Triangle> soup;
    for (int i = 0; i < n; ++i) {
        const Vec3 at = random_point(random, 0.0f, 1.0f);
        Triangle t;
        for (Vec3& p : t.corner) p = at + random_point(random, -size, size);
        soup.push_back(t);
    }
    return soup;
}

std::vector<Triangle> stress_sphere(int columns, int rows, float radius, Vec3 centre) {
    const auto point = [&](int c, int r) {
        const double phi = 2.0 * M_PI * (c % columns) / columns;
        const double theta = M_PI * r / rows;
        // The poles are single points whatever the column.
        const double ring = r == 0 || r == rows ? 0.0 : std::sin(theta);
        return centre + radius * Vec3(float(ring * std::cos(phi)), float(std::cos(theta)), float(ring * std::sin(phi)));
    };
    std::vector<Triangle> mesh;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            if (r > 0) mesh.push_back({{point(c, r), point(c + 1, r), point(c + 1, r + 1)}});
            if (r + 1 < rows) mesh.push_back({{point(c, r), point(c + 1, r + 1), point(c, r + 1)}});
        }
    return mesh;
}

std::vector<Triangle> voxel_city(int n) {
    std::vector<Triangle> city;
    for (int i = 0; i < n * n * n; ++i) {
        const int x = i / (n * n), y = i / n % n, z = i % n;
        if ((7 * x + 13 * y + 5 * z) % 3 != 0) continue;
        const Vec3 lower(x, y, z);
        for (const Triangle& t : box_faces({lower, lower + 1.0f})) city.push_back(t);
    }
    return city;
}

std::vector<Triangle> grid(Vec3 corner, Vec3 u, Vec3 v, int columns, int rows) {
    const auto point = [&](int i, int j) {
        return corner + u * (float(i) / float(columns)) + v * (float(j) / float(rows));
    };
    std::vector<Triangle> cells;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            cells.push_back({{point(i, j), point(i + 1, j), point(i + 1, j + 1)}});
            cells.push_back({{point(i, j), point(i + 1, j + 1), point(i, j + 1)}});
        }
    return cells;
}

std::vector<Triangle> scaled(std::vector<Triangle> triangles, float factor) {
    for (Triangle& t : triangles)
        for (Vec3& p : t.corner) p *= factor;
    return triangles;
}

}  // namespace kd
