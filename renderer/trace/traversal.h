// The traversals by name; the table itself is shaders/shared/traversals.glsl.
#pragma once

#include <span>
#include <string_view>

namespace kd {

enum class Traversal {
#define KD_TRAVERSAL(name, ...) name,
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
};

/// What walks read beside the nodes, and what they keep per ray: a set of these.
enum WalkNeeds : unsigned {
    walk_stack = 1,        // an entry per level of the tree
    walk_trail = 2,        // a bit per level
    walk_short_stack = 4,  // TraceConfig::short_stack entries
    walk_boxes = 8,        // the box of every node
    walk_ropes = 16,       // the links of every leaf
    walk_parents = 32,     // the link of every node to the one above
};

/// Most entries of Traversal::short_stack.
inline constexpr int max_short_stack = 8;

struct TraversalInfo {
    Traversal id;
    std::string_view name;                // on the command line
    std::string_view function;            // in the shared text
    std::string_view published_function;  // the same under rules as published; `function` where there is no such form
    unsigned needs;                       // WalkNeeds
    std::string_view summary;             // one sentence
    std::string_view paragraph;           // how it works, and what for
    std::string_view source;              // the publication that it is from

    [[nodiscard]] bool has_published_form() const { return function != published_function; }
    [[nodiscard]] bool has(WalkNeeds need) const { return (needs & need) != 0; }
};

[[nodiscard]] std::span<const TraversalInfo> traversals();
[[nodiscard]] const TraversalInfo& info(Traversal traversal);

}  // namespace kd
