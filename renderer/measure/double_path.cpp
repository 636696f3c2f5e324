#include "renderer/measure/double_path.h"

#include <limits>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "renderer/cpu/cpu_tracer.h"

namespace kd {

namespace f64 {

namespace {

/// The hooks of all four passes, in double.
class PathTracer {
  public:
    explicit PathTracer(const FlatScene& scene) : scene_(scene) {}

#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_naive
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#include "shaders/shared/triangle.glsl"
#include "shaders/shared/leaf.glsl"
#include "shaders/shared/traverse_naive.glsl"
#include "shaders/shared/traverse.glsl"
#include "shaders/shared/camera.glsl"
#include "shaders/shared/surface.glsl"
#include "shaders/shared/lighting.glsl"
#include "shaders/shared/passes.glsl"
// clang-format on
#undef KD_TRAVERSE
#undef KD_RULES

  private:
    int fetch_reference(int slot) const { return slot; }
    void on_triangle(int) {}
    void on_exit(int) {}
    int triangle_count() const { return int(scene_.triangles.size()); }
    int light_count() const { return int(scene_.lights.size()); }
    int step_budget() const { return std::numeric_limits<int>::max(); }
    bool scene_has_normals() const { return scene_.has_normals; }
    bool scene_has_textures() const { return false; }
    bool shadows_enabled() const { return true; }
    real3 scene_ambient() const { return real3(scene_.ambient); }
    real3 scene_background() const { return real3(scene_.background); }
    void fetch_bounds(real3& lower, real3& upper) const {
        lower = scene_.bounds.lower;
        upper = scene_.bounds.upper;
    }
    void fetch_corners(int, int triangle, int3 axes, real3& a, real3& b, real3& c) const {
        const auto& p = scene_.triangles[std::size_t(triangle)].corner;
        const auto corner = [&](const Vec3& v) { return real3(v[axes.x], v[axes.y], v[axes.z]); };
        a = corner(p[0]);
        b = corner(p[1]);
        c = corner(p[2]);
    }
    void fetch_normals(int triangle, real3& a, real3& b, real3& c) const {
        const auto& normal = scene_.attributes[std::size_t(triangle)].normal;
        a = real3(normal[0]);
        b = real3(normal[1]);
        c = real3(normal[2]);
    }
    real2 fetch_texture_coordinates(int, real, real) const { return real2(0); }
    int2 fetch_texture_size(int) const { return int2(1); }
    real3 fetch_texel(int, int, int) const { return real3(1); }
    int fetch_material_index(int triangle) const { return scene_.attributes[std::size_t(triangle)].material; }
    Material fetch_material(int index) const {
        const kd::Material& m = scene_.materials[std::size_t(index)];
        return {real3(m.diffuse), real3(m.specular), real3(m.reflectance), m.shininess, -1};
    }
    Light fetch_light(int index) const {
        const kd::Light& l = scene_.lights[std::size_t(index)];
        return {l.kind,  real3(l.position), real3(l.direction), real3(l.colour), real2(l.attenuation),
                l.range, l.cos_inner,       l.cos_outer};
    }

    const FlatScene& scene_;
};

real3 pixel_colour(PathTracer& tracer, const PinholeCamera& camera, int2 pixel, int2 size, int bounces,
                   real least_contribution) {
    Hit blocked{-1, 0, 0, 0};
    auto path = tracer.trace_primary(camera, pixel, size);
    real3 colour = tracer.shade_path(path, blocked);
    for (int bounce = 0; bounce < bounces; ++bounce) {
        if (!tracer.reflection_counts(tracer.reflected_weight(path), least_contribution)) break;
        path = tracer.trace_reflection(path);
        colour += tracer.shade_path(path, blocked);
    }
    return colour;
}

}  // namespace

}  // namespace f64

Image<glm::dvec3> double_frame(const FlatScene& scene, const PinholeCamera& camera, int width, int height, int bounces,
                               float least_contribution, int threads, std::stop_token stop) {
    const f64::PinholeCamera wide{glm::dvec3(camera.eye), glm::dvec3(camera.right), glm::dvec3(camera.up),
                                  glm::dvec3(camera.forward)};
    Image<glm::dvec3> image(width, height);
    tbb::task_arena arena(threads > 0 ? threads : default_threads());
    arena.execute([&] {
        tbb::parallel_for(0, height, [&](int y) {
            if (stop.stop_requested()) return;
            f64::PathTracer tracer(scene);
            for (int x = 0; x < width; ++x)
                image.at(x, y) = f64::pixel_colour(tracer, wide, int2(x, y), int2(width, height), bounces,
                                                   double(least_contribution));
        });
    });
    return image;
}

}  // namespace kd
