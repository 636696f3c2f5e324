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
    const FlatScene* scene = nullptr;
    const KdTree* tree = nullptr;
    SceneNeeds needs;
    bool duplicated = false;                   // leaves read duplicated_corners by slot, not triangles by number
    std::vector<Triangle> duplicated_corners;  // made when first asked for
    std::vector<Aabb> boxes;                   // made for traversals that climb
};

}  // namespace kd
