#include "app/engine/cell_costs.h"

#include <algorithm>
#include <utility>

namespace kd {

ThinCurve thin(const std::vector<SplitCandidate>& curve, float low, float high, int most_points) {
    ThinCurve drawn;
    const bool all = curve.size() <= std::size_t(most_points);
    const double step = (double(high) - double(low)) / most_points;
    int last_part = -1;
    for (const SplitCandidate& candidate : curve) {
        const int part = all ? int(drawn.points.size()) : int((double(candidate.position) - double(low)) / step);
        if (part != last_part) {
            drawn.points.push_back({candidate.position, candidate.cost, candidate.cost});
            last_part = part;
            continue;
        }
        ThinCurve::Point& point = drawn.points.back();
        if (candidate.cost < point.least) {
            point.least = candidate.cost;
            point.position = candidate.position;
        }
        point.most = std::max(point.most, candidate.cost);
    }
    return drawn;
}

bool CellBench::is_of(const std::shared_ptr<const World>& world, const std::string& path) const {
    return world && world_.lock() == world && path_ == path;
}

void CellBench::measure(const std::shared_ptr<const World>& world, const std::string& path, int node) {
    world_ = world;
    path_ = path;
    state_.active = true;
    state_.error.clear();
    const auto job = [this, world, path, node](const std::stop_token& stop, const BackgroundRun::Post& post) {
        CellState made;
        made.path = path;
        made.world = world;
        auto costs = cell_costs(world->scene().triangles, world->tree, node, world->built_with, stop);
        if (stop.stop_requested()) return;
        for (int axis = 0; axis < 3; ++axis)
            made.curves[std::size_t(axis)] =
                thin(costs.curves[std::size_t(axis)], costs.cell.lower[axis], costs.cell.upper[axis]);
        made.costs = std::make_shared<const CellCosts>(std::move(costs));
        post([this, made = std::move(made)] { state_ = made; });
    };
    run_.start("the costs of the cell", job, [this](const std::string& error) {
        state_.active = false;
        state_.error = error;
    });
}

void CellBench::cancel() {
    if (!state_.active) return;
    run_.cancel();
    state_.active = false;
    world_.reset();
}

}  // namespace kd
