// Scene and tree as the kernel reads them: plain pointers to tables that outlive the trace.
#pragma once

#include <span>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/trace_config.h"

namespace kd {

struct SceneView {
    /// Without any table. Both must outlive this.
    SceneView(const FlatScene& of_scene, const KdTree& of_tree);

    /// Makes the tables that `config` needs and lets go of those that it does not.
    void prepare(const TraceConfig& config);

    const FlatScene* scene = nullptr;
    const KdTree* tree = nullptr;
    SceneFacts facts;
    SceneNeeds needs;
    std::vector<Triangle> duplicated_corners;  // where needed
    std::vector<Aabb> boxes;                   // where needed
    std::vector<std::int32_t> ropes;           // where needed
    bool optimised_ropes = false;              // which
};

}  // namespace kd
