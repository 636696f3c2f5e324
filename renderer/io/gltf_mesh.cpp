#include "renderer/io/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>

#include "renderer/io/gltf_accessor.h"
#include "renderer/io/printable.h"

namespace kd {

namespace {

constexpr const char* position_name = "POSITION";

bool is_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    return find_attribute(primitive.attributes, name);
}

std::uint64_t element_count(const tinygltf::Model& model, int accessor) {
    return accessor < 0 ? 0 : model.accessors[static_cast<std::size_t>(accessor)].count;
}

/// What the mode makes of so many vertices or indices.
std::uint64_t triangle_count(int mode, std::uint64_t count) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return count / 3;
    return count < 3 ? 0 : count - 2;
}

/// Corner numbers of triangle `i` among the vertices of a primitive, all wound alike (glTF 2.0, section 3.7.2.1).
std::array<std::size_t, 3> corners(int mode, std::size_t i) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return {3 * i, 3 * i + 1, 3 * i + 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {i + 1, i + 2, 0};
    return {i, i + 1 + i % 2, i + 2 - i % 2};
}

/// The elements of an accessor as vectors of so many components.
template <class Vector>
std::vector<Vector> read_vectors(const GltfContext& context, const tinygltf::Model& model, int accessor) {
    constexpr auto length = std::size_t(Vector::length());
    static_assert(sizeof(Vector) == length * sizeof(float));
    const std::vector<float> values = read_floats(context, model, accessor);
    std::vector<Vector> vectors(values.size() / length);
    if (!vectors.empty()) std::memcpy(vectors.data(), values.data(), vectors.size() * sizeof(Vector));
    return vectors;
}

/// An attribute that goes with the positions; empty, and counted, where its type or length does not fit.
template <class Vector>
std::vector<Vector> read_companion(GltfContext& context, const tinygltf::Model& model, int accessor,
                                   std::size_t vertices, const char* noun) {
    if (accessor < 0) return {};
    const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
    if (a.count != vertices || component_count(a) != std::size_t(Vector::length()) || a.type == TINYGLTF_TYPE_MAT2) {
        context.count("ignored the " + std::string(noun) + " of", "primitive", ", which do not fit its positions");
        return {};
    }
    return read_vectors<Vector>(context, model, accessor);
}

/// Whether `given`, an accessor's min or max, is not `true_bound` but for rounding in decimals. Lists of another length
/// are no bounds.
bool contradicts(const std::vector<double>& given, Vec3 true_bound) {
    if (given.size() != 3) return false;
    const double size = std::max({std::abs(true_bound.x), std::abs(true_bound.y), std::abs(true_bound.z)});
    for (int i = 0; i < 3; ++i) {
        const double difference = std::abs(given[static_cast<std::size_t>(i)] - static_cast<double>(true_bound[i]));
        if (difference > 1e-5 * size) return true;
    }
    return false;
}

/// What the file says of the bounds is never used, so a wrong word does no harm; but it tells of a broken exporter.
void check_bounds(GltfContext& context, const tinygltf::Accessor& accessor, const std::vector<Vec3>& positions) {
    if (accessor.normalized || positions.empty()) return;  // then they are in the units of the stored integers
    Vec3 lower = positions.front();
    Vec3 upper = lower;
    for (const Vec3& p : positions) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    if (contradicts(accessor.minValues, lower) || contradicts(accessor.maxValues, upper)) {
        context.count("ignored min and max of", "primitive", ", which are not those of its positions");
    }
}

bool names_extension(const tinygltf::Model& model, std::string_view name) {
    const auto among = [&](const std::vector<std::string>& list) {
        return std::ranges::find(list, name) != list.end();
    };
    return among(model.extensionsUsed) || among(model.extensionsRequired);
}

std::vector<Vec3> read_positions(GltfContext& context, const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
    if (a.type != TINYGLTF_TYPE_VEC3 || a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        context.fail(pointer_to("/accessors", static_cast<std::size_t>(accessor)), "positions must be VEC3 of float");
    }
    if (a.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !names_extension(model, "KHR_mesh_quantization"))
        context.count("read the positions of", "primitive",
                      ", which are integers though KHR_mesh_quantization is missing");
    std::vector<Vec3> positions = read_vectors<Vec3>(context, model, accessor);
    check_bounds(context, a, positions);
    return positions;
}

/// Three vertex numbers per triangle; triangles with an index that names no vertex are left out.
std::vector<std::uint32_t> triangle_indices(GltfContext& context, const tinygltf::Model& model,
                                            const tinygltf::Primitive& primitive, std::size_t vertices) {
    const bool indexed = primitive.indices >= 0;
    const std::vector<std::uint32_t> given =
        indexed ? read_indices(context, model, primitive.indices) : std::vector<std::uint32_t>();
    const std::size_t count = indexed ? given.size() : vertices;
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES && count % 3 != 0) {
        context.count("ignored the last vertices of", "primitive", ", which make no whole triangle");
    }
    std::vector<std::uint32_t> indices;
    const std::uint64_t triangles = triangle_count(primitive.mode, count);
    indices.reserve(triangles * 3);
    std::uint64_t dropped = 0;
    for (std::size_t i = 0; i < triangles; ++i) {
        std::array<std::uint32_t, 3> triangle{};
        std::ranges::transform(corners(primitive.mode, i), triangle.begin(), [&](std::size_t corner) {
            return indexed ? given[corner] : static_cast<std::uint32_t>(corner);
        });
        if (std::ranges::any_of(triangle, [&](std::uint32_t vertex) { return vertex >= vertices; })) {
            ++dropped;
        } else {
            indices.insert(indices.end(), triangle.begin(), triangle.end());
        }
    }
    context.count("dropped", "triangle", " with an index that names no vertex", dropped);
    return indices;
}

std::vector<Vec2> read_uvs(GltfContext& context, const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                           const MaterialUse& material, std::size_t vertices) {
    const int accessor = attribute(primitive, "TEXCOORD_" + std::to_string(material.uv_set));
    if (accessor < 0) context.count("found no texture coordinates in", "primitive", " with a texture");
    std::vector<Vec2> uvs = read_companion<Vec2>(context, model, accessor, vertices, "texture coordinates");
    for (Vec2& uv : uvs) uv = material.uv.apply(uv);
    return uvs;
}

void note_omissions(GltfContext& context, const tinygltf::Primitive& primitive) {
    if (attribute(primitive, "COLOR_0") >= 0) context.count("ignored the vertex colours of", "primitive");
}

Mesh convert(GltfContext& context, const tinygltf::Model& model, const tinygltf::Primitive& primitive,
             const MaterialUse& material) {
    Mesh mesh;
    mesh.material = material.material;
    mesh.positions = read_positions(context, model, attribute(primitive, position_name));
    const std::size_t vertices = mesh.positions.size();
    mesh.indices = triangle_indices(context, model, primitive, vertices);
    mesh.normals = read_companion<Vec3>(context, model, attribute(primitive, "NORMAL"), vertices, "normals");
    if (material.uv_set >= 0) mesh.texture_coordinates = read_uvs(context, model, primitive, material, vertices);
    note_omissions(context, primitive);
    return mesh;
}

}  // namespace

void check_mesh_sizes(const GltfContext& context, const tinygltf::Model& model,
                      const std::vector<std::uint64_t>& uses) {
    const GltfLimits& limits = context.limits();
    struct Sum {
        std::uint64_t limit;
        const char* what;
        std::uint64_t value = 0;
    };
    Sum triangles{limits.triangles, "triangles with all instances"};
    Sum vertices{limits.vertices, "vertices"};
    Sum instances{limits.instances, "instances of primitives"};
    // Factors are cut to just above the limit, so that no product or sum comes near 2^64: one over it ends all.
    const auto add = [&](Sum& sum, std::uint64_t each, std::uint64_t times) {
        sum.value += std::min(each, sum.limit + 1) * std::min(times, sum.limit + 1);
        if (sum.value <= sum.limit) return;
        context.fail("", "at least " + std::to_string(sum.value) + " " + sum.what + "; the limit is " +
                             std::to_string(sum.limit));
    };
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        if (uses[i] == 0) continue;
        for (const tinygltf::Primitive& primitive : model.meshes[i].primitives) {
            const std::uint64_t positions = element_count(model, attribute(primitive, position_name));
            if (!is_triangles(primitive) || positions == 0) continue;
            const std::uint64_t count = primitive.indices >= 0 ? element_count(model, primitive.indices) : positions;
            add(triangles, triangle_count(primitive.mode, count), uses[i]);
            add(vertices, positions, 1);
            add(instances, 1, uses[i]);
        }
    }
}

std::vector<GltfPart> add_gltf_mesh(GltfContext& context, const tinygltf::Model& model, std::size_t index,
                                    GltfMaterials& materials, Scene& scene) {
    const tinygltf::Mesh& mesh = model.meshes[index];
    std::vector<GltfPart> added;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = mesh.primitives[i];
        if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            context.fail(pointer_to(pointer_to("/meshes", index) + "/primitives", i) + "/mode",
                         std::to_string(primitive.mode) + " is no primitive mode (0 to 6)");
        }
        if (!is_triangles(primitive)) {
            context.count("skipped", "primitive", " of points or lines");
        } else if (attribute(primitive, position_name) < 0) {
            context.count("skipped", "primitive", " without positions");
        } else {
            scene.meshes.push_back(convert(context, model, primitive, materials.use(primitive.material)));
            scene.meshes.back().name = printable(mesh.name);
            added.push_back({static_cast<int>(scene.meshes.size()) - 1, i});
        }
    }
    return added;
}

int find_attribute(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found != attributes.end() ? found->second : -1;
}

std::vector<Vec3> read_vertex_vectors(GltfContext& context, const tinygltf::Model& model, int accessor,
                                      std::size_t vertices, const char* noun) {
    return read_companion<Vec3>(context, model, accessor, vertices, noun);
}

std::vector<Vec4> read_vertex_quadruples(GltfContext& context, const tinygltf::Model& model, int accessor,
                                         std::size_t vertices, const char* noun) {
    return read_companion<Vec4>(context, model, accessor, vertices, noun);
}

}  // namespace kd
