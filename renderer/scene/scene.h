// A scene as people describe it, and the flat form that trees and tracers use.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/geometry/triangle.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/texture.h"

namespace kd {

class Motion;

/// Indexed triangles sharing one material. `normals` and `texture_coordinates` are empty or one per position.
struct Mesh {
    std::string name{};
    std::vector<Vec3> positions{};
    std::vector<Vec3> normals{};
    std::vector<Vec2> texture_coordinates{};
    std::vector<std::uint32_t> indices{};  // three per triangle, counter-clockwise seen from outside
    int material = 0;
};

/// A mesh placed in the world.
struct Instance {
    int mesh = 0;
    glm::mat4 to_world{1.0f};
};

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;  // see shaders/shared/types.glsl
    std::vector<std::string> material_names;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    Vec3 ambient{0.12f};
    Vec3 background{0.10f, 0.11f, 0.13f};
    std::optional<Camera> camera;          // fitted to the bounds where absent
    std::shared_ptr<const Motion> motion;  // null where nothing moves
    std::vector<std::string> notes;        // what loading dropped or replaced, one sentence each
};

/// Per-corner data of one triangle.
struct TriangleAttributes {
    Vec3 normal[3];
    Vec2 uv[3];
    int material = 0;
};

/// World-space triangles and all that shading needs. Triangle numbers index `triangles` and `attributes`.
struct FlatScene {
    std::string name;
    std::vector<Triangle> triangles;
    std::vector<TriangleAttributes> attributes;
    std::vector<std::uint32_t> kept;  // what number each triangle had before some were dropped; empty where none was
    std::vector<Material> materials;  // never empty
    std::vector<TextureImage> textures;
    std::vector<Rgba8> texels;  // of all of them: see shaders/shared/types.glsl
    std::vector<Light> lights;
    Vec3 ambient{0.0f};
    Vec3 background{0.0f};
    Aabb bounds;
    Camera camera;
    int exponent = 0;          // all lengths here times 2^exponent are in scene units: see units.h
    double duration = 0.0;     // seconds of the motion, 0 where nothing moves
    double time = 0.0;         // in seconds, 0 to below `duration`
    bool has_normals = false;  // some vertex normal differs from the geometric one
    std::vector<std::string> notes;
};

/// Of a triangle's corners; zero, which leaves the flat normal in place, where no vertex normal of the scene differs.
[[nodiscard]] inline std::array<Vec3, 3> vertex_normals(const FlatScene& scene, int triangle) {
    if (!scene.has_normals) return {Vec3(0.0f), Vec3(0.0f), Vec3(0.0f)};
    const TriangleAttributes& t = scene.attributes[std::size_t(triangle)];
    return {t.normal[0], t.normal[1], t.normal[2]};
}

/// Puts a texture behind those that the scene has; its number among them.
int add_texture(FlatScene& scene, const Texture& texture);

/// Applies the instance transforms (in double), drops triangles that are degenerate or not finite (counted in `notes`),
/// replaces bad vertex normals by geometric ones, fits a camera and adds a light where the scene has none.
[[nodiscard]] FlatScene flatten(const Scene& scene);

/// As flatten(), in the units of `like`, another pose of the scene, with its camera where the scene has none of its
/// own, and with vertex normals where that has them. A triangle may be degenerate in one pose alone: same_triangles()
/// tells.
[[nodiscard]] FlatScene flatten_like(const Scene& scene, const FlatScene& like);

/// Whether triangle numbers mean the same in both, poses of one scene: neither dropped a triangle that the other kept.
[[nodiscard]] bool same_triangles(const FlatScene& a, const FlatScene& b);

}  // namespace kd
