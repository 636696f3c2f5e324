#include "renderer/scene/scene_check.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <limits>

#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

bool names_one_of(int index, std::size_t count) { return index >= 0 && std::size_t(index) < count; }

void check_mesh(const Mesh& mesh, std::size_t number, std::size_t materials) {
    const std::string place = fmt::format("mesh {} '{}'", number, mesh.name);
    const std::size_t positions = mesh.positions.size();
    if (mesh.indices.size() % 3 != 0)
        throw InputError(fmt::format("{}: {} indices are no whole number of triangles; give three per triangle", place,
                                     mesh.indices.size()));
    const auto largest = std::ranges::max_element(mesh.indices);
    if (largest != mesh.indices.end() && *largest >= positions)
        throw InputError(
            fmt::format("{}: index {} is outside its {} positions; correct the index", place, *largest, positions));
    if (!mesh.normals.empty() && mesh.normals.size() != positions)
        throw InputError(fmt::format("{}: {} normals for {} positions; give one each or none", place,
                                     mesh.normals.size(), positions));
    if (!mesh.texture_coordinates.empty() && mesh.texture_coordinates.size() != positions)
        throw InputError(fmt::format("{}: {} texture coordinates for {} positions; give one each or none", place,
                                     mesh.texture_coordinates.size(), positions));
    // A scene without materials gets the default one as number 0.
    if (!names_one_of(mesh.material, std::max<std::size_t>(materials, 1)))
        throw InputError(
            fmt::format("{}: material {} is not one of the scene's {}; correct it", place, mesh.material, materials));
}

void check_levels(const std::vector<Image<Rgba8>>& levels, std::size_t texture) {
    if (levels.empty()) throw InputError(fmt::format("texture {}: there is no image; give one", texture));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Image<Rgba8>& image = levels[i];
        if (image.width < 1 || image.height < 1 ||
            image.pixels.size() != std::size_t(image.width) * std::size_t(image.height))
            throw InputError(fmt::format("texture {}: the image has no pixels; give at least one", texture));
        if (i > 0 && (image.width != std::max(levels[i - 1].width / 2, 1) ||
                      image.height != std::max(levels[i - 1].height / 2, 1)))
            throw InputError(
                fmt::format("texture {}: level {} is not half of the one before it; halve it", texture, i));
    }
}

void check_textures(const Scene& scene) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        for (const int texture : {material.texture, material.emission_texture, material.normal_texture})
            if (texture >= 0 && !names_one_of(texture, scene.textures.size()))
                throw InputError(
                    fmt::format("material {}: texture {} is not one of the scene's {}; correct it, or use -1 for none",
                                i, texture, scene.textures.size()));
    }
    for (std::size_t i = 0; i < scene.textures.size(); ++i) check_levels(scene.textures[i].levels, i);
}

}  // namespace

void check_scene(const Scene& scene) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) check_mesh(scene.meshes[i], i, scene.materials.size());
    check_textures(scene);
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const int mesh = scene.instances[i].mesh;
        if (!names_one_of(mesh, scene.meshes.size()))
            throw InputError(fmt::format("instance {}: mesh {} is not one of the scene's {}; correct it", i, mesh,
                                         scene.meshes.size()));
        triangles += scene.meshes[std::size_t(mesh)].indices.size() / 3;
    }
    if (triangles > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
        throw InputError(
            fmt::format("scene '{}': {} triangles are too many to number; use fewer than 2^31", scene.name, triangles));
}

}  // namespace kd
