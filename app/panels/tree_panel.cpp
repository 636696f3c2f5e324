// TREE: which builder, its constants, and what came out. Every change rebuilds at once, in the background.
#include <fmt/format.h>

#include "app/panels/panel.h"
#include "app/window/widgets.h"
#include "viz/numbers.h"

namespace kd {

namespace {

void draw_builder(Edit& edit) {
    const auto all = builders();
    int index = -1;
    for (int i = 0; i < int(all.size()); ++i)
        if (all[std::size_t(i)].name == edit.session.build.builder) index = i;
    const auto name = [&](int i) { return std::string(all[std::size_t(i)].name); };
    const auto summary = [&](int i) {
        return fmt::format("{}: {}", all[std::size_t(i)].title, all[std::size_t(i)].summary);
    };
    if (widgets::choice("builder", index, int(all.size()), name, summary,
                        "Where the tree puts its split planes. Key B: the next."))
        edit.session.build.builder = all[std::size_t(index)].name;
}

void draw_constants(BuildConfig& b, const EngineState& state) {
    widgets::slider("step cost", b.traversal_cost, 0.1f, 10, "%.2f",
                    "Cost t_t of visiting one interior node. Larger makes flatter trees with larger leaves.", true);
    widgets::slider("test cost", b.intersection_cost, 0.1f, 10, "%.2f",
                    "Cost t_i of one triangle test. Larger makes deeper trees with fewer tests.", true);
    widgets::slider(
        "empty bonus", b.empty_bonus, 0, 1, "%.2f",
        "b_e: the part of the cost forgiven when a split leaves one child empty. Larger carves off more empty space.");
    widgets::slider("leaf size", b.leaf_size, 1, 32, "%d",
                    "Nodes with at most this many triangles are not split further.");
    if (!ImGui::TreeNodeEx("more constants", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth))
        return;
    widgets::slider("bonus from", b.empty_bonus_gate, 0, 1, "%.2f",
                    "The bonus counts only where the empty child takes at least this share of the node.");
    const int automatic = state.world ? depth_limit(BuildConfig{}, state.world->scene().triangles.size()) : 0;
    widgets::slider("depth limit", b.max_depth, 0, max_tree_depth, b.max_depth == 0 ? "automatic" : "%d",
                    fmt::format("No leaf lies deeper. 0: 8 + 1.6 log2(N), here {}.", automatic));
    widgets::slider("bad splits", b.bad_refines, 0, 10, "%d",
                    "How often on one path a split may cost more than it saves before the node becomes a leaf.");
    widgets::slider("reference cap", b.reference_cap, 1, 256, "%.0f",
                    "Most entries of leaf lists per triangle: keeps hopeless scenes within memory.", true);
    widgets::toggle(
        "trim leaves", b.trim_leaves,
        "A leaf names only triangles whose surface reaches its cell. Off: all whose box does, as in the paper.");
}

void draw_statistics(const EngineState& state) {
    const TreeStats& s = state.world->stats;
    widgets::value("nodes", number_text(double(s.nodes)), "Interior nodes and leaves.");
    widgets::value("leaves, empty",
                   fmt::format("{}, {}", number_text(double(s.leaves)), number_text(double(s.empty_leaves))),
                   "Empty leaves are the space that rays cross for free.");
    widgets::value("depth, mean", fmt::format("{}, {:.1f}", s.deepest, s.mean_leaf_depth),
                   "Of the deepest leaf, and over all leaves.");
    widgets::value("largest leaf", number_text(double(s.largest_leaf)),
                   "Triangles that a ray tests there, one by one.");
    widgets::value("entries / triangle", number_text(s.references_per_triangle),
                   "How often a triangle stands in leaf lists on average: planes cut through triangles.");
    widgets::value(
        "SAH cost", number_text(s.sah_cost),
        "Expected cost of a random line in traversal steps, by the surface area heuristic. Compare with the map.");
    widgets::value("memory", fmt::format("{} kB", number_text(double(s.node_bytes + s.reference_list_bytes) / 1024)),
                   "Nodes at 16 bytes, leaf lists, and the triangles once.");
    widgets::value("built in", fmt::format("{} ms", number_text(state.last_build_ms)),
                   "Wall clock of the build, one thread.");
}

}  // namespace

void draw_tree_panel(const EngineState& state, Edit& edit) {
    draw_builder(edit);
    draw_constants(edit.session.build, state);
    if (edit.session.build != BuildConfig{.builder = edit.session.build.builder}) {
        if (widgets::button("default constants", "Back to the values that the program starts with."))
            edit.session.build = BuildConfig{.builder = edit.session.build.builder};
    }
    if (state.building.active) {
        widgets::progress(state.building.fraction, fmt::format("building {:.0f} %", 100 * state.building.fraction));
        if (widgets::button("cancel", "Keeps the tree that is shown.")) edit.do_once(Action::cancel_build);
    }
    if (state.world) draw_statistics(state);
}

}  // namespace kd
