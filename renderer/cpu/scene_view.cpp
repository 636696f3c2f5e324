#include "renderer/cpu/scene_view.h"

#include <utility>

#include "renderer/kdtree/ropes.h"

namespace kd {

SceneView::SceneView(const FlatScene& of_scene, const KdTree& of_tree, CpuMode how)
    : scene(&of_scene), tree(&of_tree), mode(how), facts(scene_facts(of_scene, of_tree)) {}

void SceneView::prepare(const TraceConfig& config) {
    needs = scene_needs(facts, config);
    if (needs.wide_nodes) packed_nodes = {};
    if (!needs.node_boxes) boxes = {};
    if (!needs.leaf_copies) duplicated_corners = {};
    if (!needs.ropes || optimised_ropes != needs.optimised_ropes) ropes = {};
    const CpuMode before = std::exchange(in_force, mode_in_force(mode, config));
    if ((before == CpuMode::scalar) != (in_force == CpuMode::scalar)) packed_nodes = {};
    if (in_force == CpuMode::scalar) leaf_blocks = {};
    if (in_force != CpuMode::scalar && leaf_blocks.empty()) leaf_blocks = LeafBlocks(*tree, scene->triangles);
    if (!needs.wide_nodes && packed_nodes.empty()) packed_nodes = encode_packed(walked_tree());
    if (needs.node_boxes && boxes.empty()) boxes = node_boxes(*tree);
    if (needs.ropes && ropes.empty()) ropes = make_ropes(*tree, needs.optimised_ropes);
    optimised_ropes = needs.optimised_ropes;
    if (needs.leaf_copies && duplicated_corners.empty())
        duplicated_corners = duplicated_leaf_triangles(*tree, scene->triangles);
}

}  // namespace kd
