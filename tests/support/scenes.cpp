#include "tests/support/scenes.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

namespace kd::test {

std::uint32_t Random::bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + 1442695040888963407ull;
    const auto shifted = std::uint32_t(((old >> 18u) ^ old) >> 27u);
    const auto turn = std::uint32_t(old >> 59u);
    return (shifted >> turn) | (shifted << ((32u - turn) & 31u));
}

float Random::uniform(float low, float high) { return low + (high - low) * (float(bits() >> 8u) / 16777216.0f); }

int Random::below(int n) { return int(bits() % std::uint32_t(n)); }

Vec3 Random::point(float low, float high) {
    const float x = uniform(low, high);
    const float y = uniform(low, high);
    return {x, y, uniform(low, high)};
}

FlatScene scene_of(std::vector<Triangle> triangles) {
    FlatScene scene;
    scene.name = "test";
    for (const Triangle& t : triangles) {
        const Vec3 cross = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
        const Vec3 normal = glm::dot(cross, cross) > 0 ? glm::normalize(cross) : Vec3(0, 0, 1);
        scene.attributes.push_back({{normal, normal, normal}, {}, 0});
        for (const Vec3& p : t.corner) scene.bounds.include(p);
    }
    scene.triangles = std::move(triangles);
    scene.materials = {{Vec3(0.7f), Vec3(0.2f), Vec3(0.0f), 20.0f, -1}};
    scene.lights = {{KD_LIGHT_POINT, Vec3(2, 5, 3), Vec3(0, -1, 0), Vec3(0.8f), Vec2(1, 0), 0.0f, 1.0f, 0.0f}};
    scene.ambient = Vec3(0.1f);
    scene.background = Vec3(0.05f, 0.06f, 0.08f);
    scene.camera = fit_camera(scene.bounds);
    return scene;
}

std::vector<Triangle> random_soup(int n, float size, unsigned seed) {
    Random random(seed);
    std::vector<Triangle> soup;
    for (int i = 0; i < n; ++i) {
        const Vec3 at = random.point(0.0f, 1.0f);
        Triangle t;
        for (Vec3& p : t.corner) p = at + random.point(-size, size);
        soup.push_back(t);
    }
    return soup;
}

std::vector<Triangle> sphere(int columns, int rows, float radius, Vec3 centre) {
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
    // With r == 0 the second triangle alone closes the cap, with r == rows - 1 the first alone.
    return mesh;
}

std::vector<Triangle> voxel_city(int n) {
    static constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                        {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    std::vector<Triangle> city;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) {
                if ((7 * x + 13 * y + 5 * z) % 3 != 0) continue;
                const auto corner = [&](int i) { return Vec3(x + (i >> 2 & 1), y + (i >> 1 & 1), z + (i & 1)); };
                for (const auto& f : faces) {
                    city.push_back({{corner(f[0]), corner(f[1]), corner(f[2])}});
                    city.push_back({{corner(f[0]), corner(f[2]), corner(f[3])}});
                }
            }
    return city;
}

FlatScene mirror_scene(int soup_triangles, unsigned seed) {
    std::vector<Triangle> triangles = random_soup(soup_triangles, 0.12f, seed);
    const std::size_t ball_begin = triangles.size();
    for (const Triangle& t : sphere(16, 10, 0.3f, Vec3(0.5f, 0.3f, 0.6f))) triangles.push_back(t);
    const std::size_t floor_begin = triangles.size();
    const Vec3 a(-1, -0.1f, -1), b(2, -0.1f, -1), c(2, -0.1f, 2), d(-1, -0.1f, 2);
    triangles.push_back({{a, b, c}});
    triangles.push_back({{a, c, d}});

    FlatScene scene = scene_of(std::move(triangles));
    scene.materials.push_back({Vec3(0.3f, 0.3f, 0.35f), Vec3(0.1f), Vec3(0.5f, 0.4f, 0.3f), 50.0f, -1});
    scene.materials.push_back({Vec3(0.2f, 0.5f, 0.3f), Vec3(0.4f), Vec3(0.3f), 80.0f, 0});
    Image<Rgba8> checker(5, 3);
    for (std::size_t i = 0; i < checker.pixels.size(); ++i)
        checker.pixels[i] = {static_cast<unsigned char>(40 * i % 256), static_cast<unsigned char>(255 - 13 * i), 128,
                             255};
    scene.textures.push_back(checker);
    for (std::size_t i = ball_begin; i < floor_begin; ++i) {
        TriangleAttributes& t = scene.attributes[i];
        t.material = 2;
        for (std::size_t k = 0; k < 3; ++k) {
            t.normal[k] = glm::normalize(scene.triangles[i].corner[k] - Vec3(0.5f, 0.3f, 0.6f));
            t.uv[k] = Vec2(scene.triangles[i].corner[k].x * 3.0f, scene.triangles[i].corner[k].y * 2.0f);
        }
    }
    for (std::size_t i = floor_begin; i < scene.triangles.size(); ++i) scene.attributes[i].material = 1;
    scene.has_normals = true;
    scene.lights.push_back({KD_LIGHT_SPOT, Vec3(-1, 3, 0), glm::normalize(Vec3(1, -2, 0.4f)), Vec3(3.0f),
                            Vec2(0.5f, 0.2f), 20.0f, 0.95f, 0.6f});
    scene.camera = {Vec3(0.4f, 1.2f, 3.0f), Vec3(0.5f, 0.3f, 0.5f), Vec3(0, 1, 0), 40.0f};
    return scene;
}

std::vector<Ray> unkind_rays(const std::vector<Triangle>& triangles, int n, unsigned seed) {
    Random random(seed);
    const auto corner = [&] {
        return triangles[std::size_t(random.below(int(triangles.size())))].corner[std::size_t(random.below(3))];
    };
    const auto towards = [](Vec3 from, Vec3 to) { return Ray{from, to - from, 0.0f, KD_T_LIMIT, -1}; };
    const auto axis_direction = [&] {
        // The two other components are +0 or -0.
        Vec3 d(random.below(2) ? 0.0f : -0.0f, random.below(2) ? 0.0f : -0.0f, random.below(2) ? 0.0f : -0.0f);
        d[random.below(3)] = random.below(2) ? 1.0f : -1.0f;
        return d;
    };
    std::vector<Ray> rays;
    while (int(rays.size()) < n) {
        const Vec3 from = random.point(-1.5f, 2.5f);
        const Vec3 p = corner();
        switch (random.below(8)) {
            case 0: rays.push_back(towards(from, p)); break;
            case 1: rays.push_back(towards(from, glm::mix(p, corner(), random.uniform(0, 1)))); break;
            case 2: rays.push_back({from, axis_direction(), 0.0f, KD_T_LIMIT, -1}); break;
            case 3: rays.push_back({p, axis_direction(), 0.0f, KD_T_LIMIT, -1}); break;
            case 4: rays.push_back(towards(p, corner())); break;
            case 5: {  // inside a plane through a vertex
                Vec3 o = from, d = random.point(-1, 1);
                const int axis = random.below(3);
                o[axis] = p[axis];
                d[axis] = random.below(2) ? 0.0f : -0.0f;
                rays.push_back({o, d, 0.0f, KD_T_LIMIT, -1});
                break;
            }
            case 6: rays.push_back(towards(from * 1000.0f, p)); break;
            default: rays.push_back(towards(from, random.point(0, 1))); break;
        }
    }
    return rays;
}

std::string hex(const Ray& ray) {
    char text[256];
    std::snprintf(text, sizeof text, "o=(%a, %a, %a) d=(%a, %a, %a) t=(%a, %a) source=%d", double(ray.origin.x),
                  double(ray.origin.y), double(ray.origin.z), double(ray.direction.x), double(ray.direction.y),
                  double(ray.direction.z), double(ray.t_min), double(ray.t_max), ray.source);
    return text;
}

}  // namespace kd::test
