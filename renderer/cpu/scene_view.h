// Scene and tree as the kernel reads them: plain pointers to tables that outlive the trace.
#pragma once

#include <span>
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

    /// Makes the tables that `config` needs and lets go of those that it does not.
    void prepare(const TraceConfig& config);

    /// The tree's own, or the packed ones where they are needed; of the tree in blocks where leaves are.
    template <class Node>
    [[nodiscard]] const Node* nodes() const {
        if constexpr (std::is_same_v<Node, PackedNode>)
            return packed_nodes.data();
        else
            return walked_tree().nodes.data();
    }
    [[nodiscard]] const KdTree& walked_tree() const { return in_force == CpuMode::scalar ? *tree : leaf_blocks.tree; }

    const FlatScene* scene = nullptr;
    const KdTree* tree = nullptr;
    CpuMode mode = CpuMode::scalar, in_force = CpuMode::scalar;  // as asked for, and what the configuration leaves
    SceneFacts facts;
    SceneNeeds needs;
    LeafBlocks leaf_blocks;                    // where the mode in force is not scalar
    std::vector<PackedNode> packed_nodes;      // where needed
    std::vector<Triangle> duplicated_corners;  // where needed
    std::vector<Aabb> boxes;                   // where needed
    std::vector<std::int32_t> ropes;           // where needed
    bool optimised_ropes = false;              // which
};

}  // namespace kd
