#include "renderer/cpu/scene_view.h"

#include <utility>

#include "renderer/kdtree/ropes.h"

namespace kd {

SceneView::SceneView(const FlatScene& of_scene, const KdTree& of_tree, CpuMode how)
    : scene(&of_scene), tree(&of_tree), mode(how), facts(scene_facts(of_scene, of_tree)) {}

bool SceneView::prepare(const TraceConfig& config, int threads, const std::stop_token& stop) {
    needs = scene_needs(facts, config);
    const CpuMode before = std::exchange(in_force, mode_in_force(mode, config, needs.masks));
    if (in_blocks()) needs.leaf_copies = false;  // blocks are copies
    let_go(before);
    if (in_blocks() && !make_blocks(threads, stop)) return false;
    if (!needs.wide_nodes && packed_nodes.empty()) packed_nodes = encode_packed(in_blocks() ? over_blocks : *tree);
    if (!needs.wide_nodes) over_blocks.nodes = {};
    if (needs.node_boxes && boxes.empty()) boxes = node_boxes(*tree);
    if (needs.ropes && ropes.empty()) ropes = make_ropes(*tree, needs.optimised_ropes);
    optimised_ropes = needs.optimised_ropes;
    if (needs.leaf_copies && duplicated_corners.empty())
        duplicated_corners = duplicated_leaf_triangles(*tree, scene->triangles);
    return true;
}

void SceneView::let_go(CpuMode before) {
    if (needs.wide_nodes) packed_nodes = {};
    if (!needs.node_boxes) boxes = {};
    if (!needs.leaf_copies) duplicated_corners = {};
    if (!needs.ropes || optimised_ropes != needs.optimised_ropes) ropes = {};
    if ((before == CpuMode::scalar) != (in_force == CpuMode::scalar)) packed_nodes = {};
    if (in_blocks()) return;
    leaf_blocks = {};
    over_blocks.nodes = {};
}

bool SceneView::make_blocks(int threads, const std::stop_token& stop) {
    const bool has_nodes = needs.wide_nodes ? !over_blocks.nodes.empty() : !packed_nodes.empty();
    if (has_nodes && !leaf_blocks.empty()) return true;
    over_blocks = tree_over_blocks(*tree);
    if (leaf_blocks.empty()) leaf_blocks = make_leaf_blocks(*tree, over_blocks, scene->triangles, threads, stop);
    return !leaf_blocks.empty() || tree->references.empty();
}

}  // namespace kd
