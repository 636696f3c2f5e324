#include "renderer/gl/scene_upload.h"

#include <algorithm>
#include <bit>
#include <glm/vec4.hpp>

#include "renderer/kdtree/encode.h"
#include "renderer/kdtree/ropes.h"

namespace kd {

namespace {

using Words = glm::uvec4;

constexpr int loop_check_rounds = 4;  // see check_loops() in shaders/opengl/observer_hooks.glsl

unsigned bits(float x) { return std::bit_cast<unsigned>(x); }

Words words(Vec3 v, unsigned w) { return {bits(v.x), bits(v.y), bits(v.z), w}; }

/// Materials, lights and the places of images, as fetch_material and its like in shaders/opengl read them.
std::vector<Words> encode_tables(const FlatScene& scene) {
    std::vector<Words> table;
    for (const Material& m : scene.materials) {
        table.push_back(words(m.diffuse, bits(m.shininess)));
        table.push_back(words(m.specular, unsigned(m.texture)));
        table.push_back(words(m.reflectance, unsigned(m.emission_texture)));
        table.push_back(words(m.emission, bits(m.roughness)));
        table.emplace_back(unsigned(m.normal_texture), bits(m.normal_scale), bits(m.alpha_cutoff), 0u);
    }
    for (const Light& l : scene.lights) {
        table.push_back(words(l.position, unsigned(l.kind)));
        table.push_back(words(l.direction, bits(l.range)));
        table.push_back(words(l.colour, bits(l.radius)));
        table.emplace_back(bits(l.attenuation.x), bits(l.attenuation.y), bits(l.cos_inner), bits(l.cos_outer));
    }
    for (const TextureImage& image : scene.textures)
        table.emplace_back(unsigned(image.first), unsigned(image.width), unsigned(image.height),
                           unsigned(image.levels | image.wrap_x << 8 | image.wrap_y << 16));
    return table;
}

/// One 128-bit texel per corner, as in the paper.
std::vector<Vec4> encode_corners(const std::vector<Triangle>& triangles) {
    std::vector<Vec4> texels;
    texels.reserve(3 * triangles.size());
    for (const Triangle& t : triangles)
        for (const Vec3& p : t.corner) texels.emplace_back(p, 0.0f);
    return texels;
}

std::vector<Vec4> encode_boxes(const std::vector<Aabb>& boxes) {
    std::vector<Vec4> texels;
    texels.reserve(2 * boxes.size());
    for (const Aabb& box : boxes) {
        texels.emplace_back(box.lower, 0.0f);
        texels.emplace_back(box.upper, 0.0f);
    }
    return texels;
}

/// All boxes, then two texels of ropes per node: whole numbers, like the nodes' own links.
std::vector<Vec4> encode_boxes_and_ropes(const KdTree& tree, bool optimised) {
    std::vector<Vec4> texels = encode_boxes(node_boxes(tree));
    const std::vector<std::int32_t> ropes = make_ropes(tree, optimised);
    for (std::size_t i = 0; i < ropes.size(); i += 3)
        texels.emplace_back(float(ropes[i]), float(ropes[i + 1]), float(ropes[i + 2]), 0.0f);
    return texels;
}

std::vector<Vec4> encode_normals(const FlatScene& scene) {
    std::vector<Vec4> texels;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        for (const Vec3& normal : vertex_normals(scene, int(i))) texels.emplace_back(normal, 0.0f);
    return texels;
}

std::vector<Vec2> encode_texture_coordinates(const FlatScene& scene) {
    std::vector<Vec2> texels;
    for (const TriangleAttributes& t : scene.attributes) texels.insert(texels.end(), std::begin(t.uv), std::end(t.uv));
    return texels;
}

std::vector<std::int32_t> encode_material_index(const FlatScene& scene) {
    std::vector<std::int32_t> texels;
    for (const TriangleAttributes& t : scene.attributes) texels.push_back(t.material);
    return texels;
}

gl_blocks::SceneBlock encode_block(const FlatScene& scene, int nodes, int step_budget, int only_material) {
    const int lights_at = texels_per_material * int(scene.materials.size());
    const int textures_at = lights_at + texels_per_light * int(scene.lights.size());
    return {
        .bounds_lower = Vec4(scene.bounds.lower, 0.0f),
        .bounds_upper = Vec4(scene.bounds.upper, 0.0f),
        .ambient = Vec4(scene.ambient, 0.0f),
        .background = Vec4(scene.background, 1.0f),
        .counts = {int(scene.triangles.size()), int(scene.lights.size()), lights_at, textures_at},
        .limits = {step_budget, loop_check_rounds, only_material, nodes},
    };
}

}  // namespace

SceneUpload::SceneUpload(const GlApi& gl, const GlLimits& limits, const FlatScene& scene, const KdTree& tree)
    : gl_(gl), limits_(limits), scene_(scene), tree_(tree), sizes_(upload_sizes(scene, tree)),
      facts_((check_upload(sizes_, limits), scene_facts(scene, tree))), block_(gl),
      corners_(gl, GL_RGBA32F, encode_corners(scene.triangles), "triangles"),
      tables_(gl, GL_RGBA32UI, encode_tables(scene), "materials and lights") {}

void SceneUpload::set_block(int step_budget, int only_material) {
    const int budget = step_budget > 0 ? std::min(step_budget, gl_step_budget) : gl_step_budget;
    const std::array<int, 2> wanted{budget, only_material};
    if (block_holds_ == wanted) return;
    block_holds_ = wanted;
    block_.set(gl_, encode_block(scene_, int(tree_.nodes.size()), budget, only_material));
}

void SceneUpload::upload_references(bool wide) {
    if (references_ && wide_references_ == wide) return;
    wide_references_ = wide;
    references_ = {};
    if (wide) {
        references_ = BufferTexture(gl_, GL_R32UI, tree_.references, "leaf lists");
    } else {
        const std::vector<std::uint16_t> narrow(tree_.references.begin(), tree_.references.end());
        references_ = BufferTexture(gl_, GL_R16UI, narrow, "leaf lists of 16 bits");
    }
}

void SceneUpload::prepare(const TraceConfig& config, const SceneNeeds& needs) {
    check_config(sizes_, config, limits_);
    set_block(config.step_budget, needs.only_material);
    upload_references(needs.wide_references);
    const auto keep = [&](BufferTexture& table, bool needed, GLenum format, const char* what, const auto& encode) {
        if (!needed)
            table = {};
        else if (!table)
            table = BufferTexture(gl_, format, encode(), what);
    };
    keep(nodes_, needs.wide_nodes, GL_RGBA32F, "nodes", [&] { return encode_float4(tree_); });
    keep(packed_nodes_, !needs.wide_nodes, GL_RG32UI, "nodes of 8 bytes", [&] { return encode_packed(tree_); });
    keep(material_index_, needs.material_numbers, GL_R32I, "material numbers",
         [&] { return encode_material_index(scene_); });
    keep(boxes_, needs.node_boxes && !needs.ropes, GL_RGBA32F, "node boxes",
         [&] { return encode_boxes(node_boxes(tree_)); });
    if (!enters_by_tile(config)) cells_ = {};
    if (enters_by_tile(config) && cells_.empty()) cells_ = node_boxes(tree_);
    if (optimised_ropes_ != needs.optimised_ropes) boxes_and_ropes_ = {};
    optimised_ropes_ = needs.optimised_ropes;
    keep(boxes_and_ropes_, needs.ropes, GL_RGBA32F, "node boxes and ropes",
         [&] { return encode_boxes_and_ropes(tree_, needs.optimised_ropes); });
    keep(leaf_corners_, needs.leaf_copies, GL_RGBA32F, "leaf triangles",
         [&] { return encode_corners(duplicated_leaf_triangles(tree_, scene_.triangles)); });
    keep(normals_, needs.normals, GL_RGBA32F, "normals", [&] { return encode_normals(scene_); });
    keep(texture_coordinates_, needs.images(), GL_RG32F, "texture coordinates",
         [&] { return encode_texture_coordinates(scene_); });
    keep(
        texels_, needs.images(), GL_RGBA8UI, "images", [&]() -> const auto& { return scene_.texels; });
}

void SceneUpload::bind() const {
    block_.bind(gl_, scene_block);
    const auto bind_both = [&](const BufferTexture& table, Unit unit) {
        table.bind(gl_, unit);
        table.bind_storage(gl_, unit);
    };
    bind_both(packed_nodes_ ? packed_nodes_ : nodes_, Unit::nodes);
    bind_both(boxes_and_ropes_ ? boxes_and_ropes_ : boxes_, Unit::boxes);
    bind_both(references_, Unit::references);
    bind_both(leaf_corners_, Unit::leaf_corners);
    bind_both(corners_, Unit::corners);
    material_index_.bind(gl_, Unit::material_index);
    normals_.bind(gl_, Unit::normals);
    texture_coordinates_.bind(gl_, Unit::texture_coordinates);
    tables_.bind(gl_, Unit::tables);
    texels_.bind(gl_, Unit::texels);
}

void SceneUpload::add_to(GlMemory& memory) const {
    memory.nodes += nodes_.bytes() + packed_nodes_.bytes();
    memory.boxes += boxes_.bytes() + boxes_and_ropes_.bytes();
    memory.references += references_.bytes();
    memory.triangles += corners_.bytes() + leaf_corners_.bytes();
    memory.attributes += material_index_.bytes() + normals_.bytes() + texture_coordinates_.bytes() + tables_.bytes();
    memory.textures += texels_.bytes();
}

}  // namespace kd
