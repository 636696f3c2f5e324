#include "tests/support/scenes.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "renderer/scene/parts.h"

namespace kd::test {

float Random::uniform(float low, float high) { return float(between(low, high)); }

int Random::below(int n) { return int(next() % std::uint64_t(n)); }

Vec3 Random::point(float low, float high) {
    const float x = uniform(low, high);
    const float y = uniform(low, high);
    return {x, y, uniform(low, high)};
}

FlatScene mirror_scene(int soup_triangles, unsigned seed) {
    std::vector<Triangle> triangles = random_soup(soup_triangles, 0.12f, seed);
    const std::size_t ball_begin = triangles.size();
    for (const Triangle& t : stress_sphere(16, 10, 0.3f, Vec3(0.5f, 0.3f, 0.6f))) triangles.push_back(t);
    const std::size_t floor_begin = triangles.size();
    const Vec3 a(-1, -0.1f, -1), b(2, -0.1f, -1), c(2, -0.1f, 2), d(-1, -0.1f, 2);
    triangles.push_back({{a, b, c}});
    triangles.push_back({{a, c, d}});

    FlatScene scene = scene_of(std::move(triangles));
    scene.materials = {glossy(Vec3(0.7f), 0.2f, 20.0f)};
    scene.materials.push_back(
        {Vec3(0.3f, 0.3f, 0.35f), Vec3(0.1f), Vec3(0.5f, 0.4f, 0.3f), Vec3(0.0f), 50.0f, -1, -1, 0.0f, -1, 1.0f, 0.0f});
    scene.materials.push_back(
        {Vec3(0.2f, 0.5f, 0.3f), Vec3(0.4f), Vec3(0.3f), Vec3(0.0f), 80.0f, 0, -1, 0.0f, -1, 1.0f, 0.0f});
    Image<Rgba8> checker(5, 3);
    for (std::size_t i = 0; i < checker.pixels.size(); ++i)
        checker.pixels[i] = {static_cast<unsigned char>(40 * i % 256), static_cast<unsigned char>(255 - 13 * i), 128,
                             255};
    add_texture(scene, plain_texture(checker));
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
    scene.lights = {point_light(Vec3(2, 5, 3), Vec3(0.8f))};
    scene.lights.push_back({KD_LIGHT_SPOT, Vec3(-1, 3, 0), glm::normalize(Vec3(1, -2, 0.4f)), Vec3(3.0f),
                            Vec2(0.5f, 0.2f), 20.0f, 0.95f, 0.6f, 0.0f});
    scene.camera = {Vec3(0.4f, 1.2f, 3.0f), Vec3(0.5f, 0.3f, 0.5f), Vec3(0, 1, 0), 40.0f};
    return scene;
}

FlatScene soft_scene(int n, unsigned seed) {
    FlatScene scene = mirror_scene(n, seed);
    scene.lights.push_back(scene.lights.front());
    scene.lights.back().kind = KD_LIGHT_DIRECTIONAL;
    scene.lights.back().direction = glm::normalize(Vec3(0.3f, -1.0f, -0.2f));
    for (Light& light : scene.lights) light.radius = light.kind == KD_LIGHT_DIRECTIONAL ? 0.1f : 0.3f;
    for (Material& material : scene.materials) material.roughness = 0.4f;
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
