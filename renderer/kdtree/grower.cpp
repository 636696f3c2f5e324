#include "renderer/kdtree/grower.h"

#include <cassert>
#include <utility>

#include "renderer/kdtree/coverage.h"

namespace kd {

Grower::Grower(const BuildTask& task, GrowersShare& shared, Seed seed)
    : task_(task), shared_(shared), lists_(std::move(seed.lists)), splitter_(std::move(seed.splitter)),
      chooser_(task.config, *splitter_), depth_limit_(depth_limit(task.config, task.triangles.size())),
      clock_(report_.phases) {
    SharedRooms::Room room = shared_.rooms.take();
    lists_.swap_room(room);
    tree_.nodes.clear();
    pending_.push_back(seed.at);
    pending_.back().parent = -1;
    pending_.back().is_above = false;  // whoever joins the parts links to it
}

void Grower::give_room_back() {
    SharedRooms::Room room;
    lists_.swap_room(room);
    if (!room.empty()) shared_.rooms.give_back(std::move(room));
}

Seed Grower::rest() {
    give_room_back();
    return {pending_.back(), std::move(lists_), std::move(splitter_)};
}

KdTree Grower::grow() {
    while (!pending_.empty()) {
        begin_cell();
        const std::optional<Split> split = choose(pending_.back());
        if (!split) {
            make_leaf();
            continue;
        }
        divide(pending_.back(), *split);
        const int node = add_node(pending_.back());
        tree_.nodes[std::size_t(node)].flag = split->axis;
        tree_.nodes[std::size_t(node)].split = split->position;
        // Last in, first out: the child below becomes the next node.
        pending_.push_back(take_below(pending_.back(), *split, node));
    }
    shared_.progress.advance(untold_);
    shared_.budget.spend(unspent_);
    clock_.finish();
    return std::move(tree_);
}

std::optional<Grower::Halves> Grower::halve() {
    begin_cell();
    Pending& at = pending_.back();
    const std::optional<Split> split = choose(at);
    if (!split) return std::nullopt;
    divide(at, *split);
    const Pending below = take_below(at, *split, -1);
    Seed lower = top_alone(below);
    lists_.drop();
    splitter_->dropped();
    Seed upper = top_alone(at);
    clock_.end(&BuildPhases::divide);
    clock_.finish();
    return Halves{*split, std::move(lower), std::move(upper)};
}

int Grower::add_node(const Pending& at) {
    const int node = int(tree_.nodes.size());
    tree_.nodes.emplace_back().parent = at.parent;
    if (at.is_above) tree_.nodes[std::size_t(at.parent)].link = node;
    return node;
}

std::optional<Split> Grower::choose(const Pending& at) {
    const std::optional<Split> split = allowed(at);
    clock_.end(&BuildPhases::choose);
    return split;
}

/// Where the top cell is split, or nothing where a limit says leaf.
std::optional<Split> Grower::allowed(const Pending& at) {
    if (lists_.top().empty() || task_.stop.stop_requested() || shared_.budget.is_overspent()) return std::nullopt;
    // A cell without a surface is met with probability 0, and has no axis to split.
    if (!(at.cell.surface_area() > 0.0)) return std::nullopt;
    const bool placed = chooser_.is_placed(at.path);
    if (!placed && lists_.top().size() <= std::size_t(task_.config.leaf_size)) return std::nullopt;
    if (at.path.depth >= depth_limit_) {
        report_.depth_limit_hit = true;
        return std::nullopt;
    }
    std::optional<Split> split = placed ? chooser_.by_hand(at.path, at.cell, lists_) : std::nullopt;
    if (!split) split = chooser_.by_rule(at.cell, lists_);
    if (!split || at.bad_refines + split->bad > task_.config.bad_refines) return std::nullopt;
    if (std::int64_t(split->below) + split->above > at.allowance) {
        report_.reference_cap_hit = true;
        return std::nullopt;
    }
    return split;
}

void Grower::divide(const Pending& at, const Split& split) {
    splitter_->divide(at.cell, split, lists_);
    assert(int(lists_.top().size()) == split.below);
    clock_.end(&BuildPhases::divide);
}

/// Makes the cell that was split the child above, and gives the one below.
Pending Grower::take_below(Pending& at, const Split& split, int node) {
    at.parent = node;
    at.bad_refines += split.bad;
    Pending below = at;
    below.is_above = false;
    below.path = at.path.child(false);
    below.cell.upper[split.axis] = split.position;
    const std::int64_t references = std::int64_t(split.below) + split.above;
    below.allowance = at.allowance * split.below / references;
    below.work = at.work * split.below / double(references);

    at.is_above = true;
    at.path = at.path.child(true);
    at.cell.lower[split.axis] = split.position;
    at.allowance -= below.allowance;
    at.work -= below.work;
    return below;
}

void Grower::make_leaf() {
    const Pending& at = pending_.back();
    TreeNode& leaf = tree_.nodes[std::size_t(add_node(at))];
    leaf.link = std::int32_t(tree_.references.size());
    const bool trim = task_.config.trim_leaves;
    for (const std::int32_t t : lists_.top())
        if (!trim || !surface_avoids(task_.triangles[std::size_t(t)], at.cell)) tree_.references.push_back(t);
    leaf.count = std::int32_t(tree_.references.size()) - leaf.link;
    // By and by: threads that write the same memory at every leaf wait for each other.
    unspent_ += leaf.count;
    if (unspent_ >= 4096) shared_.budget.spend(std::exchange(unspent_, 0));
    lists_.drop();
    splitter_->dropped();
    clock_.end(&BuildPhases::leaves);
    untold_ += at.work;
    if (untold_ >= 0.25 * SharedProgress::least_step) shared_.progress.advance(std::exchange(untold_, 0.0));
    // What this leaf leaves over, the next cell may use.
    const std::int64_t left_over = at.allowance - leaf.count;
    pending_.pop_back();
    if (!pending_.empty()) pending_.back().allowance += left_over;
}

}  // namespace kd
