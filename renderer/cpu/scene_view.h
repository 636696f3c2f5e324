// Scene and tree as the kernel reads them: plain pointers to tables that outlive the trace.
#pragma once

#include <span>
#include <stop_token>
#include <type_traits>
#include <vector>

#include "renderer/cpu/cpu_mode.h"
#include "renderer/cpu/leaf_blocks.h"
#include "renderer/kdtree/encode.h"
#include "renderer/kdtree/tree.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

struct SceneView {
    /// Without any table. Both must outlive this.
    SceneView(const FlatScene& of_scene, const KdTree& of_tree, CpuMode how = CpuMode::scalar);

    /// Makes the tables that `config` needs, on `threads` threads (0 = all), and lets go of those that it does not.
    /// False where stopped before the end.
    bool prepare(const TraceConfig& config, int threads = 0, const std::stop_token& stop = {});

    /// The tree's own, or the packed ones where they are needed; of the tree in blocks where leaves are.
    template <class Node>
    [[nodiscard]] const Node* nodes() const {
        if constexpr (std::is_same_v<Node, PackedNode>)
            return packed_nodes.data();
        else
            return (in_blocks() ? over_blocks : *tree).nodes.data();
    }
    /// Whether leaves are read eight triangles at a time.
    [[nodiscard]] bool in_blocks() const { return in_force != CpuMode::scalar; }

    const FlatScene* scene = nullptr;
    const KdTree* tree = nullptr;
    CpuMode mode = CpuMode::scalar, in_force = CpuMode::scalar;  // as asked for, and what the configuration leaves
    SceneFacts facts;
    SceneNeeds needs;
    std::vector<LeafBlock> leaf_blocks;        // where in_blocks()
    KdTree over_blocks{{}, {}, {}};            // the tree whose leaves lead to them; no nodes where they are packed
    std::vector<PackedNode> packed_nodes;      // where needed
    std::vector<Triangle> duplicated_corners;  // where needed
    std::vector<Aabb> boxes;                   // where needed
    std::vector<std::int32_t> ropes;           // where needed
    bool optimised_ropes = false;              // which

  private:
    void let_go(CpuMode before);
    bool make_blocks(int threads, const std::stop_token& stop);
};

}  // namespace kd
