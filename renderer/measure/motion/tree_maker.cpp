#include "renderer/measure/motion/tree_maker.h"

#include <utility>

#include "renderer/kdtree/refit.h"

namespace kd {

TreeMaker::TreeMaker(std::string way, const BuildConfig& config, std::span<const Triangle> at_rest, int threads)
    : way_(std::move(way)), config_(config), threads_(threads) {
    if (way_ == refit_way) {
        first_ = build_tree(at_rest, config_, nullptr, {}, {}, threads_);
        first_triangles_ = at_rest.size();
    } else {
        config_.builder = way_;
    }
}

KdTree TreeMaker::make(std::span<const Triangle> triangles, const std::stop_token& stop, BuildReport* report) {
    if (way_ == refit_way) {
        RefitReport refit;
        if (auto tree = refit_tree(first_, first_triangles_, triangles, config_, {}, &refit, stop, threads_)) {
            if (report) {
                *report = {};
                report->seconds = refit.seconds;
            }
            return *std::move(tree);
        }
        ++refused_;
        why_refused_ = std::move(refit.why_none);
    }
    return build_tree(triangles, config_, report, {}, stop, threads_);
}

}  // namespace kd
