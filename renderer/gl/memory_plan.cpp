#include "renderer/gl/memory_plan.h"

#include "renderer/gl/frame_targets.h"
#include "renderer/gl/gl_limits.h"

namespace kd {

GlMemory planned_memory(const FlatScene& scene, const KdTree& tree, const SceneNeeds& needs, int width, int height) {
    constexpr std::int64_t texel = 16;
    const UploadSizes sizes = upload_sizes(scene, tree);
    GlMemory memory;
    memory.nodes = bytes_of(needs.wide_nodes ? NodeEncoding::float4 : NodeEncoding::packed) * sizes.nodes;
    if (needs.node_boxes) memory.boxes = 2 * texel * sizes.nodes;
    if (needs.ropes) memory.boxes = 4 * texel * sizes.nodes;  // the boxes before them
    memory.references = (needs.wide_references ? 4 : 2) * sizes.references;
    memory.triangles = 3 * texel * (sizes.triangles + (needs.leaf_copies ? sizes.references : 0));
    memory.attributes = texel * sizes.table_texels;
    if (needs.material_numbers) memory.attributes += 4 * sizes.triangles;
    if (needs.normals) memory.attributes += 3 * texel * sizes.triangles;
    if (needs.images()) {
        memory.attributes += 3 * 8 * sizes.triangles;  // coordinates
        memory.textures = 4 * sizes.texels;
    }
    memory.targets = target_bytes(target_key(needs, width, height));
    return memory;
}

}  // namespace kd
