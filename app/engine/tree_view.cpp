#include "app/engine/tree_view.h"

#include <algorithm>
#include <utility>

#include "renderer/kdtree/hand_split.h"

namespace kd {

namespace {

std::vector<int> cells_of_nodes(const KdTree& tree, const std::vector<IcicleCell>& icicle) {
    std::vector<int> cell_of(tree.nodes.size(), -1);
    for (std::size_t i = 0; i < icicle.size(); ++i) cell_of[std::size_t(icicle[i].node)] = int(i);
    // Nodes follow their parents.
    for (std::size_t i = 1; i < cell_of.size(); ++i)
        if (cell_of[i] < 0) cell_of[i] = cell_of[std::size_t(tree.nodes[i].parent)];
    return cell_of;
}

}  // namespace

void TreeViewBench::follow(const TreeViewWish& wish, const std::shared_ptr<const World>& world,
                           const std::shared_ptr<const NodeVisits>& visits) {
    if (wish == wish_ && world_.lock() == world && visits_.lock() == visits) return;
    wish_ = wish;
    world_ = world;
    visits_ = visits;
    state_.active = world && wish.columns > 0;
    if (!state_.active) return run_.cancel();
    state_.error.clear();
    const auto job = [this, wish, world, visits](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const KdTree& tree = world->tree;
        TreeView made;
        made.of = wish;
        made.world = world;
        made.visits = visits;
        made.root = node_at(tree, wish.root).value_or(0);
        made.icicle = icicle(tree, wish.width, 1.0 / wish.columns, made.root);
        made.cell_of = cells_of_nodes(tree, made.icicle);
        for (const IcicleCell& cell : made.icicle) made.rows = std::max(made.rows, cell.depth + 1);
        if (stop.stop_requested()) return;
        made.slice = slice_cells(tree, wish.slice, max_tree_depth);
        made.segments = slice_triangles(world->scene().triangles, wish.slice);
        if (stop.stop_requested()) return;
        made.colours = colour_nodes(tree, wish.colour, wish.colormap, visits.get());
        if (visits) made.predicted = visits->predicted(tree);
        post([this, made = std::make_shared<const TreeView>(std::move(made))] { state_.view = made; });
    };
    run_.start("the views of the tree", job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

}  // namespace kd
