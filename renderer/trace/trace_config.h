// How a frame is traced, whatever traces it.
#pragma once

#include "renderer/trace/feature.h"
#include "renderer/trace/rules.h"
#include "renderer/trace/sampling.h"
#include "renderer/trace/traversal.h"

namespace kd {

/// Where leaves keep their triangles (paper, section 2.3.1): numbers into one array, or copies of the vertices.
enum class LeafLists { references, duplicated };

/// How a tracer keeps the nodes: the paper's 16 bytes (its section 2.3.1), or 8 without a link to the parent.
enum class NodeEncoding { float4, packed };

/// Of one node.
[[nodiscard]] constexpr int bytes_of(NodeEncoding nodes) { return nodes == NodeEncoding::float4 ? 16 : 8; }

struct TraceConfig {
    Traversal traversal = Traversal::stack;
    Rules rules = Rules::robust;
    LeafLists leaf_lists = LeafLists::references;
    NodeEncoding nodes = NodeEncoding::float4;  // what nodes_in_force() leaves of it
    int short_stack = 4;                        // entries that Traversal::short_stack keeps, 1 to max_short_stack
    bool optimised_ropes = true;  // ropes lead to the smallest cell beyond a face, not to the sibling across the plane
    bool eye_leaf = false;        // with ropes, primary rays begin in the leaf that the camera is in
    int entry_tile = 0;  // without ropes, primary rays begin at the entry point of their tile of n x n pixels; 0 = root
    int packet_size = 16;  // rays that CpuMode::packet walks together: 4, 8 or 16
    bool shadows = true;
    int reflection_depth = 1;           // bounces; the paper's one-bounce reflection
    float least_contribution = 0.004f;  // a reflection that adds less (0..1 per channel) is not followed: 1/255
    Sampling sampling{};
    bool counters = true;
    int step_budget = 0;  // steps after which a walk is ended and flagged; 0 = the tracer's own, which is also the most
    FeatureSet forced{};  // kept though nothing asks for them: the picture stays the same (renderer/scene/needs.h)

    bool operator==(const TraceConfig&) const = default;
};

/// The same for all frames of samples: what programs, tables and speed hang on.
[[nodiscard]] inline TraceConfig at_first_sample(TraceConfig config) {
    if (config.sampling.sample > 0) config.sampling.sample = 0;
    return config;
}

/// Walks that climb need the link to the parent, whatever is chosen.
[[nodiscard]] inline NodeEncoding nodes_in_force(const TraceConfig& config) {
    return info(config.traversal).has(walk_parents) ? NodeEncoding::float4 : config.nodes;
}

/// Primary rays begin in the leaf of the eye: only ropes lead on from there.
[[nodiscard]] inline bool enters_by_eye(const TraceConfig& config) {
    return config.eye_leaf && info(config.traversal).has(walk_ropes);
}

/// Primary rays begin at entry points of tiles: robust walks down from a node, which ropes and the naive loop are not.
[[nodiscard]] inline bool enters_by_tile(const TraceConfig& config) {
    return config.entry_tile > 0 && config.rules == Rules::robust && config.traversal != Traversal::naive &&
           !info(config.traversal).has(walk_ropes);
}

}  // namespace kd
