#include "renderer/gl/gl_limits.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/encode.h"
#include "renderer/scene/needs_sizes.h"

namespace kd {

namespace {

void check_texels(std::string_view what, std::int64_t texels, std::int64_t limit, std::string_view remedy) {
    if (texels > limit)
        throw InputError(fmt::format("scene on OpenGL: {} take {} texels, a texture buffer holds {} here; {}", what,
                                     texels, limit, remedy));
}

void check_storage(std::string_view what, std::int64_t bytes, std::int64_t limit, std::string_view remedy) {
    if (bytes > limit)
        throw InputError(fmt::format("scene on OpenGL: {} take {} bytes, a storage buffer holds {} here; {}", what,
                                     bytes, limit, remedy));
}

/// Of a table that walks read.
void check_table(std::string_view what, std::int64_t texels, std::int64_t bytes_per_texel, const GlLimits& limits,
                 std::string_view remedy) {
    check_texels(what, texels, limits.buffer_texels, remedy);
    check_storage(what, texels * bytes_per_texel, limits.storage_bytes, remedy);
}

void check_number(std::string_view what, std::int64_t largest, std::string_view where, std::int64_t limit,
                  std::string_view remedy) {
    if (largest > limit)
        throw InputError(fmt::format("scene on OpenGL: {} {} do not fit {}, which number things exactly up to {}; {}",
                                     largest, what, where, limit, remedy));
}

/// That every number which stands in a node is held exactly by this encoding.
void check_node_numbers(const UploadSizes& sizes, NodeEncoding nodes) {
    for (const auto& [what, largest] : {std::pair("nodes", sizes.nodes), {"leaf list entries", sizes.references}})
        if (nodes == NodeEncoding::float4)
            check_number(what, largest, "the tree's float4 texels", float_index_limit,
                         "use --nodes 8, larger leaves or --tracer cpu");
        else
            check_number(what, largest, "the links of nodes of 8 bytes", packed_link_limit,
                         "use larger leaves or --tracer cpu");
}

}  // namespace

UploadSizes upload_sizes(const FlatScene& scene, const KdTree& tree) {
    UploadSizes sizes;
    sizes.nodes = std::int64_t(tree.nodes.size());
    sizes.references = std::int64_t(tree.references.size());
    sizes.triangles = std::int64_t(scene.triangles.size());
    sizes.lights = std::int64_t(scene.lights.size());
    sizes.texels = std::int64_t(scene.texels.size());
    sizes.table_texels = texels_per_material * std::int64_t(scene.materials.size()) + texels_per_light * sizes.lights +
                         std::int64_t(scene.textures.size());
    return sizes;
}

void check_upload(const UploadSizes& sizes, const GlLimits& limits) {
    check_texels("the tree's nodes", sizes.nodes, limits.buffer_texels, "use larger leaves or --tracer cpu");
    check_texels("the leaf lists", sizes.references, limits.buffer_texels, "use larger leaves or --tracer cpu");
    check_table("the triangles", 3 * sizes.triangles, 16, limits, "use a smaller scene or --tracer cpu");
    check_texels("the images", sizes.texels, limits.buffer_texels, "use smaller images or --tracer cpu");
    check_texels("materials and lights", sizes.table_texels, limits.buffer_texels, "use fewer or --tracer cpu");
}

void check_config(const UploadSizes& sizes, const TraceConfig& config, const GlLimits& limits) {
    const auto has = [&](bool needed, Feature feature) { return needed || config.forced.has(feature); };
    const bool wide = has(nodes_in_force(config) == NodeEncoding::float4, Feature::wide_nodes);
    const NodeEncoding nodes = wide ? NodeEncoding::float4 : NodeEncoding::packed;
    check_node_numbers(sizes, nodes);
    check_storage("the tree's nodes", bytes_of(nodes) * sizes.nodes, limits.storage_bytes,
                  wide ? "use --nodes 8, larger leaves or --tracer gl-fragment" : "use larger leaves or --tracer cpu");
    const bool wide_lists = has(sizes.triangles > narrow_numbers, Feature::wide_references);
    check_storage("the leaf lists", (wide_lists ? 4 : 2) * sizes.references, limits.storage_bytes,
                  "use larger leaves or --tracer cpu");
    if (has(config.leaf_lists == LeafLists::duplicated, Feature::leaf_copies))
        check_table("copied leaf lists", 3 * sizes.references, 16, limits, "use leaf lists of references");
    if (has(info(config.traversal).has(walk_boxes) || enters_by_tile(config), Feature::node_boxes))
        check_table("the boxes of all nodes", 2 * sizes.nodes, 16, limits, "use --traversal stack");
    if (has(info(config.traversal).has(walk_ropes), Feature::ropes)) {
        check_table("boxes and ropes of all nodes", 4 * sizes.nodes, 16, limits, "use --traversal stack");
        check_number("nodes", sizes.nodes, "the float texels of ropes", float_index_limit, "use --traversal stack");
    }
    if (config.traversal == Traversal::naive) {
        // One invocation traces the shadow rays to all lights.
        const std::int64_t rays = config.shadows ? std::max<std::int64_t>(1, sizes.lights) : 1;
        if (sizes.triangles * rays > gl_step_budget)
            throw InputError(
                fmt::format("traversal naive on OpenGL: {} triangles times {} rays per shader call exceed {} "
                            "loop steps; use another traversal, --tracer cpu or a smaller scene",
                            sizes.triangles, rays, gl_step_budget));
    }
}

void check_image(int width, int height, const GlLimits& limits) {
    if (width > limits.texture_size || height > limits.texture_size)
        throw InputError(fmt::format("image of {}x{} pixels: a texture holds {}x{} here; ask for a smaller one", width,
                                     height, limits.texture_size, limits.texture_size));
}

}  // namespace kd
