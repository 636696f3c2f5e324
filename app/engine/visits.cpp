#include "app/engine/visits.h"

#include <fmt/format.h>

#include "app/engine/state.h"

namespace kd {

FrameBench::Work count_visits(const TracedFrame& traced, Pass rays, int threads, VisitState& state) {
    return [traced, rays, threads, &state](const std::stop_token& stop,
                                           const std::function<void(float)>& progress) -> std::function<void()> {
        auto counted = count_node_visits(walk_request(traced, rays, threads), stop, progress);
        if (!counted) return {};
        const auto visits = std::make_shared<const NodeVisits>(*std::move(counted));
        const KdTree& tree = traced.world->tree;
        const std::string whose = fmt::format("{} rays", ray_names[std::size_t(rays)]);
        const auto scatter = std::make_shared<const VisitScatter>(visit_scatter(tree, *visits, whose));
        return [&state, visits, scatter, world = traced.world, agreed = agreement(tree, *visits)] {
            state.visits = visits;
            state.world = world;
            state.agreement = agreed;
            state.scatter = scatter;
        };
    };
}

}  // namespace kd
