#include "renderer/kdtree/replay.h"

#include "renderer/kdtree/hand_split.h"
#include "renderer/kdtree/plane_chooser.h"

namespace kd {

namespace {

/// A builder with the lists of one cell after another on a way down.
class Replay {
  public:
    Replay(const BuildTask& task, const Aabb& bounds)
        : ranges_(task.triangles, bounds), cell_(bounds),
          splitter_(find_builder(task.config.builder)->splitter(task, ranges_)), lists_(ranges_),
          chooser_(task.config, *splitter_) {}

    /// As the build did, but for its limits.
    [[nodiscard]] std::optional<Split> choose(bool hands) const {
        if (!(cell_.surface_area() > 0.0)) return std::nullopt;
        std::optional<Split> split = hands ? chooser_.by_hand(at_, cell_, lists_) : std::nullopt;
        return split ? split : chooser_.by_rule(cell_, lists_);
    }

    void take(const WayStep& step) {
        const int axis = step.split.axis;
        splitter_->divide(cell_, step.split, lists_);
        if (step.above) {
            lists_.drop();
            splitter_->dropped();
            cell_.lower[axis] = step.split.position;
        } else {
            cell_.upper[axis] = step.split.position;
        }
        at_ = at_.child(step.above);
    }

  private:
    TriangleRanges ranges_;
    Aabb cell_;
    std::unique_ptr<Splitter> splitter_;
    CellLists lists_;
    PlaneChooser chooser_;
    NodePath at_;
};

}  // namespace

std::vector<WayStep> way_to(const KdTree& tree, int node) {
    std::vector<WayStep> way;
    int at = 0;
    for (const char step : node_path(tree, node)) {
        const TreeNode& n = tree.nodes[std::size_t(at)];
        const bool above = step == path_above;
        way.push_back({{.axis = n.flag, .position = n.split}, above});
        at = above ? n.link : at + 1;
    }
    return way;
}

void learn_planar_sides(const BuildTask& task, const Aabb& bounds, std::vector<WayStep>& way) {
    Replay replay(task, bounds);
    for (WayStep& step : way) {
        if (task.stop.stop_requested()) return;
        const std::optional<Split> chosen = replay.choose(true);
        if (chosen && chosen->axis == step.split.axis && chosen->position == step.split.position)
            step.split.planar_below = chosen->planar_below;
        replay.take(step);
    }
}

std::optional<Split> choice_at_end(const BuildTask& task, const Aabb& bounds, const std::vector<WayStep>& way) {
    Replay replay(task, bounds);
    for (const WayStep& step : way) replay.take(step);
    return replay.choose(false);
}

}  // namespace kd
