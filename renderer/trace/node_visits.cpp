#include "renderer/trace/node_visits.h"

#include "renderer/kdtree/stats.h"

namespace kd {

std::vector<double> NodeVisits::predicted(const KdTree& tree) const {
    std::vector<double> visits = visit_probabilities(tree);
    for (double& v : visits) v *= double(rays);
    return visits;
}

}  // namespace kd
