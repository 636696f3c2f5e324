// How a frame is traced, whatever traces it.
#pragma once

#include "renderer/trace/feature.h"
#include "renderer/trace/rules.h"
#include "renderer/trace/traversal.h"

namespace kd {

/// Where leaves keep their triangles (paper, section 2.3.1): numbers into one array, or copies of the vertices.
enum class LeafLists { references, duplicated };

struct TraceConfig {
    Traversal traversal = Traversal::stack;
    Rules rules = Rules::robust;
    LeafLists leaf_lists = LeafLists::references;
    bool shadows = true;
    int reflection_depth = 1;           // bounces; the paper's one-bounce reflection
    float least_contribution = 0.004f;  // a reflection that adds less (0..1 per channel) is not followed: 1/255
    bool counters = true;
    int step_budget = 0;  // steps after which a walk is ended and flagged; 0 = the tracer's own, which is also the most
    FeatureSet forced{};  // kept though nothing asks for them: the picture stays the same (renderer/scene/needs.h)

    bool operator==(const TraceConfig&) const = default;
};

}  // namespace kd
