// glTF materials and their textures.
#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <tiny_gltf.h>

#include "renderer/io/gltf_context.h"
#include "renderer/io/gltf_surface.h"
#include "renderer/scene/scene.h"

namespace kd {

/// KHR_texture_transform: scale, then rotate counter-clockwise as seen with v pointing down, then move.
struct UvTransform {
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  // radians

    [[nodiscard]] Vec2 apply(Vec2 uv) const;
    bool operator==(const UvTransform&) const = default;
};

/// A material of the scene, and which texture coordinates its primitives must bring.
struct MaterialUse {
    int material = 0;
    int uv_set = -1;  // n of TEXCOORD_n; -1 where it has no texture
    UvTransform uv;
};

/// Converts materials, and decodes their textures, when they are first asked for.
class GltfMaterials {
  public:
    GltfMaterials(GltfContext& context, const tinygltf::Model& model, Scene& scene);

    /// The scene's material for glTF material `index`; glTF's default material for -1 or an index that names none
    /// (noted).
    const MaterialUse& use(int index);

  private:
    struct TextureUse {
        int texture = -1;  // of the scene
        int uv_set = 0;
        UvTransform uv;

        [[nodiscard]] bool same_place(const TextureUse& other) const {
            return uv_set == other.uv_set && uv == other.uv;
        }
    };
    /// What a texture of the scene is made of: the file's image, KD_WRAP_... each way, whether with mip maps.
    struct ImageUse {
        int image = 0;
        int wrap_x = KD_WRAP_REPEAT, wrap_y = KD_WRAP_REPEAT;
        bool mip_maps = true;
        TexelKind kind = TexelKind::colour;

        auto operator<=>(const ImageUse&) const = default;
    };
    MaterialUse add(int index);
    PbrSurface metallic_surface(const tinygltf::PbrMetallicRoughness& pbr, TextureUse& texture);
    PbrSurface glossy_surface(const tinygltf::Value& extension, TextureUse& texture);
    void add_emission(const tinygltf::Material& material, TextureUse& base, Material& made);
    void add_normals(const tinygltf::Material& material, TextureUse& base, Material& made);
    void add_mask(const tinygltf::Material& material, double alpha, Material& made);
    int image_of_texture(int texture);
    ImageUse sampled_image(int texture, int image, TexelKind kind);
    int texture_of(const ImageUse& use);
    TextureUse scene_texture(int texture, int uv_set, const tinygltf::Value* transform,
                             TexelKind kind = TexelKind::colour);
    bool share_place(TextureUse& base, const TextureUse& image);
    [[nodiscard]] Vec3 mean_of(int texture) const;
    double in_range(double factor);
    glm::dvec3 in_range(const std::vector<double>& factors);

    GltfContext& context_;
    const tinygltf::Model& model_;
    Scene& scene_;
    std::map<int, MaterialUse> uses_;
    std::map<ImageUse, int> texture_of_image_;
    std::uint64_t pixels_left_;
};

}  // namespace kd
