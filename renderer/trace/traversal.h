// The traversals by name; the table itself is shaders/shared/traversals.glsl.
#pragma once

#include <span>
#include <string_view>

namespace kd {

enum class Traversal {
#define KD_TRAVERSAL(name, label, published, needs_boxes, needs_stack, summary) name,
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
};

struct TraversalInfo {
    Traversal id;
    std::string_view name;                // on the command line
    std::string_view function;            // in the shared text
    std::string_view published_function;  // the same under rules as published; `function` where there is no such form
    bool needs_boxes;                     // reads the box of every node
    bool needs_stack;
    std::string_view summary;

    [[nodiscard]] bool has_published_form() const { return function != published_function; }
};

[[nodiscard]] std::span<const TraversalInfo> traversals();
[[nodiscard]] const TraversalInfo& info(Traversal traversal);

}  // namespace kd
