#include "renderer/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <string_view>
#include <utility>

#include "renderer/geometry/cofactors.h"
#include "renderer/scene/parts.h"
#include "renderer/scene/scene_check.h"
#include "renderer/scene/units.h"

namespace kd {

namespace {

/// Twice a triangle's area times the distance of a ray's origin must not underflow.
constexpr double smallest_area = 0x1p-100;

/// What flattening had to drop or replace.
struct Tally {
    std::int64_t degenerate = 0, out_of_range = 0, too_small = 0, normals = 0, texture_coordinates = 0, lights = 0;
};

/// An instance's matrix, in double, split into what positions and normals need.
struct Placement {
    glm::dmat3 linear;
    glm::dvec3 translation;
    glm::dmat3 cofactors;
    double handedness = 1;
};

Placement placement_of(const glm::mat4& to_world) {
    Placement p;
    p.linear = glm::dmat3(glm::dvec3(to_world[0]), glm::dvec3(to_world[1]), glm::dvec3(to_world[2]));
    p.translation = glm::dvec3(to_world[3]);
    p.cofactors = cofactors(p.linear);
    p.handedness = handedness(p.linear, p.cofactors);
    return p;
}

bool within_limit(Vec3 point) {
    // Written so that NaN fails.
    return std::abs(point.x) <= KD_COORDINATE_LIMIT && std::abs(point.y) <= KD_COORDINATE_LIMIT &&
           std::abs(point.z) <= KD_COORDINATE_LIMIT;
}

/// Twice the area times the normal. In double, where differences and products of floats of similar size are exact:
/// corners on one line give exactly zero.
glm::dvec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

bool is_zero(glm::dvec3 v) { return glm::dot(v, v) == 0.0; }

/// Unit normals that differ by more than 1e-4 radians.
bool differ_noticeably(glm::dvec3 a, glm::dvec3 b) {
    return glm::dot(a, b) < 0.0 || glm::length(glm::cross(a, b)) > 1e-4;
}

class Flattener {
  public:
    explicit Flattener(FlatScene& flat) : flat_(flat) {}

    void add_instance(const Mesh& mesh, const glm::mat4& to_world) {
        const Placement placement = placement_of(to_world);
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
            std::array<std::uint32_t, 3> vertices{mesh.indices[first], mesh.indices[first + 1],
                                                  mesh.indices[first + 2]};
            // A mirror image would turn the triangle's outside in.
            if (placement.handedness < 0.0) std::swap(vertices[1], vertices[2]);
            add_triangle(mesh, placement, vertices);
        }
    }

    /// After all instances: brings the triangles to internal units, and drops those whose tests would underflow in
    /// them.
    void finish(const FlatScene* like) {
        if (like)
            rescale(flat_, like->exponent);
        else
            rescale(flat_);
        std::size_t kept = 0;
        Aabb bounds;
        for (std::size_t i = 0; i < flat_.triangles.size(); ++i) {
            const auto& [a, b, c] = flat_.triangles[i].corner;
            if (glm::length(area_vector(a, b, c)) < smallest_area) continue;
            for (const Vec3& p : flat_.triangles[i].corner) bounds.include(p);
            flat_.triangles[kept] = flat_.triangles[i];
            flat_.kept[kept] = flat_.kept[i];
            flat_.attributes[kept++] = flat_.attributes[i];
        }
        tally_.too_small = std::int64_t(flat_.triangles.size() - kept);
        flat_.triangles.resize(kept);
        flat_.attributes.resize(kept);
        flat_.kept.resize(kept);
        if (kept == offered_) flat_.kept = {};
        flat_.bounds = bounds;
    }

    [[nodiscard]] const Tally& tally() const { return tally_; }

  private:
    void add_triangle(const Mesh& mesh, const Placement& placement, const std::array<std::uint32_t, 3>& vertices) {
        const auto number = std::uint32_t(offered_++);
        std::array<Vec3, 3> local;
        Triangle world;
        for (std::size_t i = 0; i < 3; ++i) {
            local[i] = mesh.positions[vertices[i]];
            world.corner[i] = Vec3(placement.linear * glm::dvec3(local[i]) + placement.translation);
        }
        if (!std::ranges::all_of(world.corner, within_limit)) {
            ++tally_.out_of_range;
            return;
        }
        // Rounding can hide that the corners are on one line before it, or bring them onto one.
        const glm::dvec3 area = area_vector(world.corner[0], world.corner[1], world.corner[2]);
        if (is_zero(area) || is_zero(placement.cofactors * area_vector(local[0], local[1], local[2]))) {
            ++tally_.degenerate;
            return;
        }
        flat_.triangles.push_back(world);
        flat_.kept.push_back(number);
        flat_.attributes.push_back(attributes_of(mesh, placement, vertices, glm::normalize(area)));
        for (const Vec3& corner : world.corner) flat_.bounds.include(corner);
    }

    TriangleAttributes attributes_of(const Mesh& mesh, const Placement& placement,
                                     const std::array<std::uint32_t, 3>& vertices, glm::dvec3 geometric) {
        TriangleAttributes attributes{};
        attributes.material = mesh.material;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = vertices[i];
            attributes.normal[i] =
                mesh.normals.empty() ? Vec3(geometric) : world_normal(placement, mesh.normals[vertex], geometric);
            if (!mesh.texture_coordinates.empty()) attributes.uv[i] = usable(mesh.texture_coordinates[vertex]);
        }
        return attributes;
    }

    Vec3 world_normal(const Placement& placement, Vec3 normal, glm::dvec3 geometric) {
        const glm::dvec3 turned = placement.handedness * (placement.cofactors * glm::dvec3(normal));
        const double length = glm::length(turned);
        if (!(length > 0.0) || !std::isfinite(length)) {
            ++tally_.normals;
            return Vec3(geometric);
        }
        const glm::dvec3 unit = turned / length;
        flat_.has_normals = flat_.has_normals || differ_noticeably(unit, geometric);
        return Vec3(unit);
    }

    Vec2 usable(Vec2 uv) {
        if (std::isfinite(uv.x) && std::isfinite(uv.y)) return uv;
        ++tally_.texture_coordinates;
        return Vec2(0.0f);
    }

    FlatScene& flat_;
    std::size_t offered_ = 0;  // triangles so far, kept or not
    Tally tally_;
};

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_usable(const Light& light) {
    return is_finite(light.position) && is_finite(light.direction) && is_finite(light.colour) &&
           std::isfinite(light.attenuation.x) && std::isfinite(light.attenuation.y) && std::isfinite(light.range) &&
           std::isfinite(light.cos_inner) && std::isfinite(light.cos_outer) && std::isfinite(light.radius);
}

/// Lights and camera, with replacements where the scene has none that can be used.
void add_view(const Scene& scene, const FlatScene* like, FlatScene& flat, Tally& tally) {
    if (scene.camera && is_valid(*scene.camera) && is_valid(to_internal(flat, *scene.camera))) {
        flat.camera = to_internal(flat, *scene.camera);
    } else {
        flat.camera = like ? like->camera : fit_camera(flat.bounds);
        if (scene.camera)
            flat.notes.emplace_back(
                "replaced the scene's camera, which cannot be used, by one that sees the whole scene");
    }
    for (const Light& light : scene.lights)
        if (is_usable(light) && is_usable(to_internal(flat, light))) flat.lights.push_back(to_internal(flat, light));
    tally.lights = std::int64_t(scene.lights.size() - flat.lights.size());
    if (flat.lights.empty()) {
        flat.lights.push_back(default_light(flat.camera));
        flat.notes.emplace_back("added a point light beside the camera, as the scene has none");
    }
}

void note(FlatScene& flat, std::int64_t count, std::string_view verb, std::string_view noun,
          std::string_view why = "") {
    if (count > 0) flat.notes.push_back(fmt::format("{} {} {}{}{}", verb, count, noun, count == 1 ? "" : "s", why));
}

FlatScene flatten(const Scene& scene, const FlatScene* like) {
    check_scene(scene);
    FlatScene flat;
    flat.name = scene.name;
    flat.materials = scene.materials;
    if (flat.materials.empty()) flat.materials.push_back(default_material());
    for (const Texture& texture : scene.textures) add_texture(flat, texture);
    flat.ambient = scene.ambient;
    flat.background = scene.background;
    flat.notes = scene.notes;

    Flattener flattener(flat);
    for (const Instance& instance : scene.instances)
        flattener.add_instance(scene.meshes[std::size_t(instance.mesh)], instance.to_world);

    flattener.finish(like);
    if (like) flat.has_normals = flat.has_normals || like->has_normals;

    Tally tally = flattener.tally();
    add_view(scene, like, flat, tally);
    note(flat, tally.degenerate, "dropped", "degenerate triangle");
    note(flat, tally.out_of_range, "dropped", "triangle", " with coordinates that are not finite or beyond 1.844e18");
    note(flat, tally.too_small, "dropped", "triangle", " too small beside the scene for single precision");
    note(flat, tally.normals, "replaced", "vertex normal", " that cannot be used by the triangle's own");
    note(flat, tally.texture_coordinates, "replaced", "texture coordinate", " that are not finite by 0");
    note(flat, tally.lights, "dropped", "light", " with values that are not finite");
    return flat;
}

}  // namespace

int add_texture(FlatScene& scene, const Texture& texture) {
    const Image<Rgba8>& whole = texture.levels.front();
    scene.textures.push_back({int(scene.texels.size()), whole.width, whole.height, int(texture.levels.size()),
                              texture.wrap_x, texture.wrap_y});
    for (const Image<Rgba8>& level : texture.levels)
        scene.texels.insert(scene.texels.end(), level.pixels.begin(), level.pixels.end());
    return int(scene.textures.size()) - 1;
}

FlatScene flatten(const Scene& scene) { return flatten(scene, nullptr); }

FlatScene flatten_like(const Scene& scene, const FlatScene& like) { return flatten(scene, &like); }

bool same_triangles(const FlatScene& a, const FlatScene& b) {
    return a.triangles.size() == b.triangles.size() && a.kept == b.kept;
}

}  // namespace kd
