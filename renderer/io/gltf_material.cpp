#include "renderer/io/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "renderer/io/gltf_image.h"
#include "renderer/io/gltf_value.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr const char* glossiness_extension = "KHR_materials_pbrSpecularGlossiness";
constexpr const char* transform_extension = "KHR_texture_transform";
constexpr const char* strength_extension = "KHR_materials_emissive_strength";
constexpr double most_strength = 1000.0;  // far beyond what is white

int wrap_of(int named) {
    if (named == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return KD_WRAP_CLAMP;
    return named == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? KD_WRAP_MIRROR : KD_WRAP_REPEAT;
}

double alpha_of(const tinygltf::Value& glossiness) {
    return numbers_or(glossiness, "diffuseFactor", {1.0, 1.0, 1.0, 1.0})[3];
}

bool names_one_of(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

}  // namespace

Vec2 UvTransform::apply(Vec2 uv) const {
    const double c = std::cos(rotation);
    const double s = std::sin(rotation);
    const glm::dvec2 scaled = scale * glm::dvec2(uv);
    return Vec2(offset + glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x));
}

GltfMaterials::GltfMaterials(GltfContext& context, const tinygltf::Model& model, Scene& scene)
    : context_(context), model_(model), scene_(scene), pixels_left_(context.limits().all_image_pixels) {}

const MaterialUse& GltfMaterials::use(int index) {
    if (index != -1 && !names_one_of(index, model_.materials.size())) {
        context_.count("replaced", "material", " that the file does not have by the default");
        index = -1;
    }
    const auto known = uses_.find(index);
    return known != uses_.end() ? known->second : uses_.emplace(index, add(index)).first->second;
}

MaterialUse GltfMaterials::add(int index) {
    static const tinygltf::Material default_material;
    const tinygltf::Material& material =
        index < 0 ? default_material : model_.materials[static_cast<std::size_t>(index)];
    TextureUse texture;
    const tinygltf::Value* glossy = find_extension(material.extensions, glossiness_extension);
    const PbrSurface surface =
        glossy ? glossy_surface(*glossy, texture) : metallic_surface(material.pbrMetallicRoughness, texture);
    Material made = to_material(surface, texture.texture);
    add_emission(material, texture, made);
    add_normals(material, texture, made);
    add_mask(material, glossy ? alpha_of(*glossy) : material.pbrMetallicRoughness.baseColorFactor.at(3), made);

    scene_.materials.push_back(made);
    scene_.material_names.push_back(index < 0 ? "default" : printable(material.name));
    return {static_cast<int>(scene_.materials.size()) - 1, texture.texture >= 0 ? texture.uv_set : -1, texture.uv};
}

PbrSurface GltfMaterials::metallic_surface(const tinygltf::PbrMetallicRoughness& pbr, TextureUse& texture) {
    const glm::dvec3 base = in_range(pbr.baseColorFactor);
    double metallic = in_range(pbr.metallicFactor);
    double roughness = in_range(pbr.roughnessFactor);

    // Materials here have one roughness each, so a texture's mean stands for it: green is roughness, blue is metal.
    if (const int image = image_of_texture(pbr.metallicRoughnessTexture.index); image >= 0) {
        const Vec3 mean =
            mean_colour(decode_gltf_image(context_, model_, static_cast<std::size_t>(image), pixels_left_));
        roughness *= double(mean.y);
        metallic *= double(mean.z);
        context_.count("replaced", "metallic-roughness texture", " by the mean of each");
    }

    texture = scene_texture(pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord,
                            find_extension(pbr.baseColorTexture.extensions, transform_extension));
    glm::dvec3 tint(1.0);
    if (texture.texture >= 0 && metallic > 0.0) {
        tint = srgb_decoded(glm::dvec3(mean_of(texture.texture)));
    }
    PbrSurface surface = metallic_roughness(base * tint, metallic, roughness);
    surface.base = base;  // the texture itself tints what is scattered
    return surface;
}

PbrSurface GltfMaterials::glossy_surface(const tinygltf::Value& extension, TextureUse& texture) {
    const std::vector<double> diffuse = numbers_or(extension, "diffuseFactor", {1.0, 1.0, 1.0, 1.0});
    const std::vector<double> specular = numbers_or(extension, "specularFactor", {1.0, 1.0, 1.0});
    if (const tinygltf::Value* info = find_object(extension, "diffuseTexture")) {
        const tinygltf::Value* extensions = find_object(*info, "extensions");
        texture = scene_texture(find_index(*info, "index").value_or(-1), find_index(*info, "texCoord").value_or(0),
                                extensions ? find_object(*extensions, transform_extension) : nullptr);
    }
    if (find_object(extension, "specularGlossinessTexture")) {
        context_.count("ignored", "specular-glossiness texture");
    }
    return specular_glossiness(in_range(diffuse), in_range(specular),
                               in_range(number_or(extension, "glossinessFactor", 1.0)));
}

/// Corners here have one pair of coordinates, those of the first image that a material has. Whether they are those of
/// `image` too.
bool GltfMaterials::share_place(TextureUse& base, const TextureUse& image) {
    if (base.texture < 0) base = image;
    return base.same_place(image);
}

void GltfMaterials::add_emission(const tinygltf::Material& material, TextureUse& base, Material& made) {
    if (std::ranges::none_of(material.emissiveFactor, [](double e) { return e != 0.0; })) return;
    double strength = 1.0;
    if (const tinygltf::Value* extension = find_extension(material.extensions, strength_extension)) {
        strength = number_or(*extension, "emissiveStrength", 1.0);
        if (!(strength >= 0.0 && strength <= most_strength)) {
            context_.note("limited the strength of an emission to 0..1000");
            strength = strength > 0.0 ? most_strength : 0.0;
        }
    }
    made.emission = Vec3(srgb_encoded(strength * in_range(material.emissiveFactor)));
    const TextureUse image = scene_texture(material.emissiveTexture.index, material.emissiveTexture.texCoord,
                                           find_extension(material.emissiveTexture.extensions, transform_extension));
    if (image.texture < 0) return;
    if (share_place(base, image)) {
        made.emission_texture = image.texture;
    } else {
        made.emission *= mean_of(image.texture);
        context_.count("replaced", "emissive texture", " by its mean, as it has its own coordinates");
    }
}

void GltfMaterials::add_normals(const tinygltf::Material& material, TextureUse& base, Material& made) {
    const TextureUse image =
        scene_texture(material.normalTexture.index, material.normalTexture.texCoord,
                      find_extension(material.normalTexture.extensions, transform_extension), TexelKind::normal);
    if (image.texture < 0) return;
    if (!share_place(base, image)) {
        context_.count("ignored", "normal map", ", as it has its own coordinates");
        return;
    }
    made.normal_texture = image.texture;
    made.normal_scale = static_cast<float>(material.normalTexture.scale);
}

/// `alpha` is the factor on that of the base texture, 0..1.
void GltfMaterials::add_mask(const tinygltf::Material& material, double alpha, Material& made) {
    if (material.alphaMode == "MASK") {
        const double cutoff = std::max(material.alphaCutoff, 0.0);
        constexpr double above_all = 2.0;
        made.alpha_cutoff =
            static_cast<float>(alpha > 0.0 ? std::min(cutoff / alpha, above_all) : above_all * (cutoff > 0.0));
    } else if (material.alphaMode != "OPAQUE") {
        context_.count("shown", "transparent material", " as opaque");
    }
}

/// The image behind a texture of the file; -1 where there is none, noted where there should be.
int GltfMaterials::image_of_texture(int texture) {
    if (texture < 0) return -1;
    if (names_one_of(texture, model_.textures.size())) {
        const int image = model_.textures[static_cast<std::size_t>(texture)].source;
        if (names_one_of(image, model_.images.size())) return image;
    }
    context_.count("ignored", "texture", " without an image that can be shown");
    return -1;
}

GltfMaterials::ImageUse GltfMaterials::sampled_image(int texture, int image, TexelKind kind) {
    ImageUse use{.image = image, .kind = kind};
    const int index = model_.textures[static_cast<std::size_t>(texture)].sampler;
    if (!names_one_of(index, model_.samplers.size())) return use;
    const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(index)];
    use.wrap_x = wrap_of(sampler.wrapS);
    use.wrap_y = wrap_of(sampler.wrapT);
    // -1 leaves the choice to us.
    use.mip_maps =
        sampler.minFilter != TINYGLTF_TEXTURE_FILTER_NEAREST && sampler.minFilter != TINYGLTF_TEXTURE_FILTER_LINEAR;
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
        context_.count("smoothed", "texture", " whose texels should be seen");
    return use;
}

int GltfMaterials::texture_of(const ImageUse& use) {
    const auto known = texture_of_image_.find(use);
    if (known != texture_of_image_.end()) return known->second;
    Image<Rgba8> image = decode_gltf_image(context_, model_, static_cast<std::size_t>(use.image), pixels_left_);
    Texture made = use.mip_maps ? mip_mapped_texture(std::move(image), use.kind) : plain_texture(std::move(image));
    made.wrap_x = use.wrap_x;
    made.wrap_y = use.wrap_y;
    scene_.textures.push_back(std::move(made));
    return texture_of_image_[use] = static_cast<int>(scene_.textures.size()) - 1;
}

GltfMaterials::TextureUse GltfMaterials::scene_texture(int texture, int uv_set, const tinygltf::Value* transform,
                                                       TexelKind kind) {
    const int image = image_of_texture(texture);
    if (image < 0) return {};
    TextureUse use{.texture = texture_of(sampled_image(texture, image, kind)), .uv_set = uv_set, .uv = {}};
    if (transform != nullptr) {
        const std::vector<double> offset = numbers_or(*transform, "offset", {0.0, 0.0});
        const std::vector<double> scale = numbers_or(*transform, "scale", {1.0, 1.0});
        use.uv = {{offset[0], offset[1]}, {scale[0], scale[1]}, number_or(*transform, "rotation", 0.0)};
        use.uv_set = find_index(*transform, "texCoord").value_or(uv_set);
    }
    return use;
}

Vec3 GltfMaterials::mean_of(int texture) const {
    return mean_colour(scene_.textures[static_cast<std::size_t>(texture)].levels.front());
}

double GltfMaterials::in_range(double factor) {
    const double clamped = std::clamp(factor, 0.0, 1.0);
    if (clamped != factor) context_.note("limited material factors outside of 0..1");
    return clamped;
}

glm::dvec3 GltfMaterials::in_range(const std::vector<double>& factors) {
    return {in_range(factors.at(0)), in_range(factors.at(1)), in_range(factors.at(2))};
}

}  // namespace kd
