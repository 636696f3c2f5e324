// The shared text in double precision: rays and the four passes, over all triangles or those whose boxes the ray meets.
#pragma once

#include <limits>

#include "renderer/measure/triangle_boxes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/sampling.h"

namespace kd::f64 {

/// Hooks that read a scene, and the shared text behind them. Walks are over all triangles; with `boxes`, those of the
/// scene, they pass over the ones that the ray cannot hit, and answer the same. Without `shadows` no shadow ray is
/// traced; `sampling` says what light is sampled.
class DoubleKernel {
  public:
    explicit DoubleKernel(const FlatScene& scene, const TriangleBoxes* boxes = nullptr, bool shadows = true,
                          const Sampling& sampling = {})
        : scene_(scene), boxes_(boxes), shadows_(shadows), sampling_(sampling) {}

#define KD_RULES KD_RULES_ROBUST
#define KD_TRAVERSE traverse_all
#define KD_TEST_LEAF test_leaf
#include "shaders/shared/texture.glsl"
#include "shaders/shared/vector.glsl"
// Each uses the ones before it.
#include "shaders/shared/ray.glsl"
// clang-format off
#include "shaders/shared/box.glsl"
#include "shaders/shared/mask.glsl"
#include "shaders/shared/triangle.glsl"
#include "shaders/shared/leaf.glsl"
#include "shaders/shared/traverse_naive.glsl"
#include "shaders/shared/traverse.glsl"
#include "shaders/shared/camera.glsl"
#include "shaders/shared/surface.glsl"
#include "shaders/shared/samples.glsl"
#include "shaders/shared/path.glsl"
#include "shaders/shared/lighting.glsl"
#include "shaders/shared/scatter.glsl"
#include "shaders/shared/passes.glsl"
// clang-format on
#undef KD_TEST_LEAF
#undef KD_TRAVERSE
#undef KD_RULES

  private:
    void traverse_all(const RaySetup& s, bool any_hit, Hit& hit) {
        if (boxes_ == nullptr || !valid_ray(s.ray)) return traverse_naive(s, any_hit, hit);
        const auto limit = [&] { return any_hit && hit.triangle >= 0 ? -1.0 : hit.t; };
        boxes_->visit(s.ray.origin, s.inverse, s.slack, limit,
                      [&](int triangle) { intersect_triangle(s, -1, triangle, hit); });
    }
    int fetch_reference(int slot) const { return slot; }
    void fetch_node_box(int, real3&, real3&) const {}  // there is no tree
    void on_leaf(int) {}
    void on_triangle(int) {}
    void on_exit(int) {}
    int triangle_count() const { return int(scene_.triangles.size()); }
    int light_count() const { return int(scene_.lights.size()); }
    int step_budget() const { return std::numeric_limits<int>::max(); }
    bool scene_has_normals() const { return scene_.has_normals; }
    bool scene_has_textures() const { return !scene_.textures.empty(); }
    bool scene_has_mip_maps() const { return true; }
    bool scene_has_wraps() const { return true; }
    bool scene_has_normal_maps() const { return !scene_.textures.empty(); }
    bool scene_has_masks() const { return true; }
    bool shadows_enabled() const { return shadows_; }
    bool scene_has_highlights() const { return true; }
    bool scene_has_emission() const { return true; }
    bool scene_has_directional_lights() const { return true; }
    bool scene_has_placed_lights() const { return true; }
    bool scene_has_spot_lights() const { return true; }
    [[nodiscard]] bool samples(bool effect) const { return sampling_.sample >= 0 && effect; }
    bool scene_has_soft_shadows() const { return samples(sampling_.soft_shadows); }
    bool scene_has_gloss() const { return samples(sampling_.gloss); }
    bool scene_has_indirect() const { return samples(sampling_.indirect); }
    int sample_number() const { return sampling_.sample; }
    uint sample_seed() const { return sampling_.seed; }
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
    void fetch_texture_coordinates(int triangle, real2& a, real2& b, real2& c) const {
        const auto& uv = scene_.attributes[std::size_t(triangle)].uv;
        a = real2(uv[0]);
        b = real2(uv[1]);
        c = real2(uv[2]);
    }
    TextureImage fetch_texture(int texture) const {
        const kd::TextureImage& image = scene_.textures[std::size_t(texture)];
        return {image.first, image.width, image.height, image.levels, image.wrap_x, image.wrap_y};
    }
    real4 fetch_texel(int index) const {
        const Rgba8 c = scene_.texels[std::size_t(index)];
        return real4(c.r, c.g, c.b, c.a);
    }
    int fetch_material_index(int triangle) const { return scene_.attributes[std::size_t(triangle)].material; }
    Material fetch_material(int index) const {
        const kd::Material& m = scene_.materials[std::size_t(index)];
        return {real3(m.diffuse), real3(m.specular), real3(m.reflectance), real3(m.emission),
                m.shininess,      m.texture,         m.emission_texture,   m.roughness,
                m.normal_texture, m.normal_scale,    m.alpha_cutoff};
    }
    Light fetch_light(int index) const {
        const kd::Light& l = scene_.lights[std::size_t(index)];
        return {l.kind,  real3(l.position), real3(l.direction), real3(l.colour), real2(l.attenuation),
                l.range, l.cos_inner,       l.cos_outer,        l.radius};
    }

    const FlatScene& scene_;
    const TriangleBoxes* boxes_;
    bool shadows_;
    Sampling sampling_;
};

}  // namespace kd::f64
