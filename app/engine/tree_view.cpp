#include "app/engine/tree_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/kdtree/hand_split.h"

namespace kd {

namespace {

constexpr float widest_ratio = 8;  // colours of counted over predicted end at eight times more and less

/// The number that each node's colour stands for; NaN = none.
std::vector<float> values_of(const KdTree& tree, CellColour colour, const NodeVisits* counted) {
    std::vector<float> values(tree.nodes.size(), NAN);
    if (colour == CellColour::depth) {
        std::ranges::copy(node_depths(tree), values.begin());
        return values;
    }
    if (!counted || counted->count.size() != values.size()) return {};
    const std::vector<double> predicted = counted->predicted(tree);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double visits = double(counted->count[i]);
        if (colour == CellColour::visits) values[i] = float(visits);
        if (colour == CellColour::predicted) values[i] = float(predicted[i]);
        if (colour == CellColour::ratio && predicted[i] > 0) values[i] = float(visits / predicted[i]);
    }
    return values;
}

ValueRange range_of(const std::vector<float>& values, CellColour colour) {
    if (colour == CellColour::ratio) return {1 / widest_ratio, widest_ratio};
    float most = 1;
    for (const float value : values) most = std::max(most, value);  // NaN is never larger
    return {colour == CellColour::depth ? 0.0f : 1.0f, std::max(most, 2.0f)};
}

std::vector<int> cells_of_nodes(const KdTree& tree, const std::vector<IcicleCell>& icicle) {
    std::vector<int> cell_of(tree.nodes.size(), -1);
    for (std::size_t i = 0; i < icicle.size(); ++i) cell_of[std::size_t(icicle[i].node)] = int(i);
    // Nodes follow their parents.
    for (std::size_t i = 1; i < cell_of.size(); ++i)
        if (cell_of[i] < 0) cell_of[i] = cell_of[std::size_t(tree.nodes[i].parent)];
    return cell_of;
}

}  // namespace

NodeColours colour_nodes(const KdTree& tree, CellColour colour, const std::string& colormap,
                         const NodeVisits* counted) {
    const std::vector<float> values = values_of(tree, colour, counted);
    NodeColours colours{range_of(values, colour), colour != CellColour::depth, colormap, {}};
    if (colour == CellColour::ratio) colours.colormap = std::ranges::find_if(colormaps(), &Colormap::diverging)->name;
    const Colormap& map = get_colormap(colours.colormap);
    colours.of.reserve(values.size());
    for (const float value : values)
        colours.of.push_back(std::isnan(value) ? untraced_colour
                                               : map(map_position(value, colours.range, colours.logarithmic)));
    return colours;
}

void TreeViewBench::follow(const TreeViewWish& wish, const std::shared_ptr<const World>& world,
                           const std::shared_ptr<const NodeVisits>& visits) {
    const bool counted = wish.colour != CellColour::depth;
    const std::shared_ptr<const NodeVisits> wanted = counted ? visits : nullptr;
    if (wish == wish_ && world_.lock() == world && visits_.lock() == wanted) return;
    wish_ = wish;
    world_ = world;
    visits_ = wanted;
    state_.active = world && wish.columns > 0;
    if (!state_.active) return run_.cancel();
    state_.error.clear();
    const auto job = [this, wish, world, wanted](const std::stop_token& stop, const BackgroundRun::Post& post) {
        const KdTree& tree = world->tree;
        TreeView made;
        made.of = wish;
        made.world = world;
        made.visits = wanted;
        made.root = node_at(tree, wish.root).value_or(0);
        made.icicle = icicle(tree, wish.width, 1.0 / wish.columns, made.root);
        made.cell_of = cells_of_nodes(tree, made.icicle);
        for (const IcicleCell& cell : made.icicle) made.rows = std::max(made.rows, cell.depth + 1);
        if (stop.stop_requested()) return;
        made.slice = slice_cells(tree, wish.slice, max_tree_depth);
        made.segments = slice_triangles(world->scene().triangles, wish.slice);
        if (stop.stop_requested()) return;
        made.colours = colour_nodes(tree, wish.colour, wish.colormap, wanted.get());
        if (wanted) made.predicted = wanted->predicted(tree);
        post([this, made = std::make_shared<const TreeView>(std::move(made))] { state_.view = made; });
    };
    run_.start("the views of the tree", job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

}  // namespace kd
