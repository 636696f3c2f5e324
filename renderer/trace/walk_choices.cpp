#include "renderer/trace/walk_choices.h"

#include <fmt/format.h>

namespace kd {

namespace {

std::string why_no_rules(const TraceConfig& config, const TraversalInfo& walk) {
    if (config.rules == Rules::robust || walk.has_published_form()) return "";
    return fmt::format("{} has no form as published and walks robustly; stack, restart and backtrack have one",
                       walk.name);
}

std::string why_one_encoding(const TraversalInfo& walk) {
    if (!walk.has(walk_parents)) return "";
    return fmt::format("{} climbs to parents, which only nodes of 16 bytes have a link to", walk.name);
}

std::string why_no_tiles(const TraceConfig& config, const TraversalInfo& walk) {
    if (walk.has(walk_ropes)) return "ropes begin in the leaf of the eye instead (eye leaf)";
    if (config.rules != Rules::robust) return "only robust rules can begin below the root";
    return "";
}

std::string why_no_packets(const TraceConfig& config) {
    if (config.traversal != Traversal::stack) return "packets walk by the stack; rays of other walks go singly";
    if (config.rules != Rules::robust) return "packets walk by robust rules; rays under other rules go singly";
    return "";
}

}  // namespace

std::string why_idle(WalkChoice choice, const TraceConfig& config) {
    const TraversalInfo& walk = info(config.traversal);
    using enum WalkChoice;
    if (config.traversal == Traversal::naive) return "the loop over all triangles (naive) walks no tree";
    switch (choice) {
        case rules: return why_no_rules(config, walk);
        case nodes: return why_one_encoding(walk);
        case short_stack: return walk.has(walk_short_stack) ? "" : "the walk keeps none; traversal short-stack does";
        case plain_ropes: return walk.has(walk_ropes) ? "" : "the walk follows none; traversal ropes does";
        case eye_leaf: return walk.has(walk_ropes) ? "" : "only ropes lead on from there; choose traversal ropes";
        case entry_tile: return why_no_tiles(config, walk);
        case packet: return why_no_packets(config);
    }
    return "";
}

Rules rules_in_force(const TraceConfig& config) {
    return info(config.traversal).has_published_form() ? config.rules : Rules::robust;
}

std::string walk_text(const TraceConfig& config) {
    const TraversalInfo& walk = info(config.traversal);
    std::string text(walk.name);
    if (walk.has(walk_short_stack))
        text += fmt::format(" of {} entr{}", config.short_stack, config.short_stack == 1 ? "y" : "ies");
    if (walk.has(walk_ropes))
        text += std::string(config.optimised_ropes ? "" : ", plain") + (config.eye_leaf ? ", from the eye's leaf" : "");
    if (enters_by_tile(config)) text += fmt::format(" from entry points of {0}x{0} tiles", config.entry_tile);
    return text;
}

}  // namespace kd
