// TREE: which builder, its constants, and what came out. Every change rebuilds at once, in the background.
#include <fmt/format.h>

#include "app/limits.h"
#include "app/panels/panel.h"
#include "app/window/theme.h"
#include "app/window/widgets.h"
#include "renderer/trace/walk_choices.h"
#include "viz/numbers.h"

namespace kd {

namespace {

void draw_builder(Edit& edit) {
    widgets::choice("builder", edit.session.build.builder, widgets::options_of(builders()),
                    "Where the tree puts its split planes. On the map medians glow around small details, the surface "
                    "area heuristics keep empty space dark. Key B: the next. Option --builder.");
}

void draw_constants(BuildConfig& b) {
    widgets::slider("traversal cost (t_t)", b.traversal_cost, 0.1f, 10, "%.2f",
                    "Of visiting one interior node. Larger: fewer, larger leaves. The map of nodes darkens, that of "
                    "triangle tests glows on surfaces. Option --traversal-cost.",
                    true);
    widgets::slider("intersection cost (t_i)", b.intersection_cost, 0.1f, 10, "%.2f",
                    "Of one triangle test. Larger: deeper trees. The map of triangle tests darkens, that of nodes "
                    "glows where much detail lies behind a pixel. Option --intersection-cost.",
                    true);
    widgets::slider("empty bonus (b_e)", b.empty_bonus, 0, 1, "%.2f",
                    "The part of the cost forgiven when a split leaves one child empty. Larger: background and the air "
                    "around things end sooner, but thin slices cost more nodes where rays graze surfaces. Option "
                    "--empty-bonus.");
    widgets::slider("leaf size", b.leaf_size, 1, 32, "%d",
                    "Nodes with at most this many triangles are not split further. Larger: tests glow evenly on all "
                    "surfaces, nodes darken. Option --leaf-size.");
    const Builder* builder = find_builder(b.builder);
    if (builder && builder->has_bins)
        widgets::slider("bins", b.bins, fewest_bins, most_bins, "%d",
                        "Planes are tried between so many bins on each axis; nodes of up to four triangles per bin "
                        "are swept exactly. Few: planes miss the edges of things, whose outlines glow. Option --bins.");
}

/// Planes that a person put, however they came there. The row stands there without any, too: the first plane pushes
/// nothing down.
void draw_hands(const EngineState& state, Edit& edit) {
    const std::vector<HandSplit>& by_hand = edit.session.build.by_hand;
    const int idle = state.world && !by_hand.empty() ? state.world->report.idle_hand_splits : 0;
    widgets::begin_row("planes by hand",
                       "They stand in the place of the builder's: the picture is dark where they keep rays from nodes "
                       "that the builder's do not. Put with SPLITS, which names those that are not used and says why. "
                       "Option --split.");
    const std::string label = by_hand.empty() ? "none"
                              : idle > 0      ? fmt::format("remove {} ({} idle)", by_hand.size(), idle)
                                              : fmt::format("remove {}", by_hand.size());
    const char* about = by_hand.empty() ? "There are none: SPLITS puts them." : "The builder chooses everywhere again.";
    if (widgets::button(label.c_str(), about, !by_hand.empty(), widgets::control_width())) edits::put_planes_back(edit);
}

void draw_more_constants(const EngineState& state, Edit& edit) {
    BuildConfig& b = edit.session.build;
    if (!widgets::fold("more constants", false)) return;
    widgets::slider("leaf block", b.leaf_block, limits::leaf_block.low, limits::leaf_block.high, "%d",
                    "Triangles that a tracer tests at once: t_i is paid for each so many of a leaf. 8 suits the "
                    "tracers cpu-wide and cpu-packet: fewer nodes and larger leaves. Option --leaf-block.");
    widgets::slider("bonus gate", b.empty_bonus_gate, 0, 1, "%.2f",
                    "The bonus counts only where the empty child takes at least this share of the node. Near 0, the "
                    "paper's rule, slices pile up along surfaces and the map of nodes glows there. Option "
                    "--empty-bonus-gate.");
    widgets::slider("empty cut", b.empty_cut, 0, 1, "%.2f",
                    "Where at least this share of a node, from one face on, is empty, it is cut off before anything "
                    "else is tried: background darkens, surfaces may glow more. 0: never. Option --empty-cut.");
    const int automatic = state.world ? depth_limit(BuildConfig{}, state.world->scene().triangles.size()) : 0;
    widgets::slider("max depth", b.max_depth, 0, max_tree_depth, b.max_depth == 0 ? "automatic" : "%d",
                    fmt::format("No leaf lies deeper. Low: dense parts of the scene end in large leaves, which the map "
                                "of triangle tests shows as hot spots. 0: 8 + 1.6 log2(N), here {}. Option "
                                "--max-depth.",
                                automatic));
    widgets::slider("bad refines", b.bad_refines, 0, 10, "%d",
                    "How often on one path a split may cost more than it saves before the node becomes a leaf. More: "
                    "hot spots of tests, where a first plane saves nothing but a second would, break up. Option "
                    "--bad-refines.");
    widgets::slider("reference cap", b.reference_cap, 1, 256, "%.0f",
                    "Most entries of leaf lists per triangle: keeps hopeless scenes within memory. Reached (a message "
                    "says so), parts of the picture stay hot. Option --reference-cap.",
                    true);
    widgets::toggle("trim leaves", b.trim_leaves,
                    "A leaf names only triangles whose surface reaches its cell. Off: all whose box does, as in the "
                    "paper; the map of triangle tests glows more, that of nodes stays. Option --box-leaves turns it "
                    "off.");
    draw_hands(state, edit);
}

/// Two ways back from constants that were tried.
void draw_presets(BuildConfig& b) {
    widgets::begin_row("constants", "All of the builder's constants at once.");
    const float half = (widgets::control_width() - ImGui::GetStyle().ItemSpacing.x) / 2;
    const BuildConfig start{.builder = b.builder, .by_hand = b.by_hand};
    const BuildConfig paper = edits::papers_rules(start);
    const auto preset = [&](const char* label, const BuildConfig& wanted, std::string_view tooltip) {
        if (widgets::button(label, b == wanted ? "The constants are these." : tooltip, b != wanted, half)) b = wanted;
    };
    preset("default", start, "Back to the values that the program starts with.");
    ImGui::SameLine();
    preset("paper's", paper,
           "The paper's rules: the bonus for every empty child, however thin, and leaves that name all triangles whose "
           "box reaches them. The paper gives no values for t_t, t_i and b_e and no limits: those are the program's.");
}

void draw_statistics(const EngineState& state) {
    if (!widgets::fold("statistics", ImGui::GetIO().DisplaySize.y >= theme::px(960))) return;
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
    const NodeEncoding nodes = nodes_in_force(state.session.trace);
    const std::int64_t node_bytes = nodes == NodeEncoding::float4 ? s.node_bytes : s.packed_node_bytes;
    widgets::value(
        "memory", fmt::format("{} kB", number_text(double(node_bytes + s.reference_list_bytes) / 1024)),
        fmt::format("Nodes at {} bytes as TRACING has them, leaf lists, and the triangles once.", bytes_of(nodes)));
    widgets::value("built in", fmt::format("{} ms", number_text(state.last_build_ms)),
                   "Wall clock of the build, on all threads.");
}

}  // namespace

void draw_tree_panel(const EngineState& state, Edit& edit) {
    draw_builder(edit);
    draw_constants(edit.session.build);
    draw_presets(edit.session.build);
    draw_more_constants(state, edit);
    if (state.world) draw_statistics(state);
}

}  // namespace kd
