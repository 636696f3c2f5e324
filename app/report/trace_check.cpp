#include "app/report/trace_check.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <utility>

#include "app/cli/counted.h"
#include "renderer/measure/compare.h"
#include "renderer/measure/ray_judge.h"
#include "renderer/scene/units.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::size_t rays_per_step = 16384;  // between looks at the stop request
constexpr std::size_t most_lines = 100;

}  // namespace

TraceCheck::TraceCheck(const FlatScene& scene, std::span<const Ray> asked, int threads, ProgressLine& progress,
                       const CommandContext& context)
    : oracle_(scene), asked_(asked), failed_(asked.size()), invalid_(asked.size()) {
    for (const Ray& ray : asked) rays_.push_back(to_internal(scene, ray));
    for (std::size_t first = 0; first < rays_.size(); first += rays_per_step) {
        progress.show(float(first) / float(rays_.size()), "double precision");
        const auto step = rays().subspan(first, std::min(rays_per_step, rays_.size() - first));
        const std::vector<f64::Hit> hits = oracle_.nearest(step, threads, context.stop);
        check_stop(context);
        exact_.insert(exact_.end(), hits.begin(), hits.end());
    }
}

void TraceCheck::compare(const std::string& who, std::span<const Hit> hits, std::span<const RayCounters> counters) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const JudgedHit judged = judge_ray(oracle_, rays_[i], exact_[i], hits[i], counters[i].exit_reason);
        if (counters[i].exit_reason == uint(KD_EXIT_INVALID_RAY)) invalid_[i] = true;
        ++counts_[std::size_t(judged.verdict)];
        if (!is_wrong(judged.verdict)) continue;
        ++wrong_;
        failed_[i] = true;
        if (failures_.size() < most_lines) failures_.push_back(failure_text(who, i, hits[i], judged));
    }
}

std::string TraceCheck::failure_text(const std::string& who, std::size_t i, const Hit& found,
                                     const JudgedHit& judged) const {
    const FlatScene& scene = oracle_.scene();
    const std::string by = judged.verdict == HitVerdict::wrong_t ? fmt::format(" by {:.4g} ulp", judged.ulps) : "";
    return fmt::format("ray {}: {}: {}{}; found {}; in double {}; the ray is {}", i, who, name_of(judged.verdict), by,
                       exact_text(to_scene_units(scene, found)), exact_text(to_scene_units(scene, judged.exact)),
                       exact_text(asked_[i]));
}

std::string TraceCheck::summary() const {
    const std::int64_t n = std::accumulate(counts_.begin(), counts_.end(), std::int64_t(0));
    return fmt::format("{} of {} answers {} wrong in double precision", wrong_, n, wrong_ == 1 ? "is" : "are") +
           wrong_text(counts_);
}

std::string TraceCheck::invalid_text() const {
    const auto n = std::ranges::count(invalid_, true);
    if (n == 0) return "";
    return fmt::format("{} of {} {} invalid, the first ray {}: without a direction, not finite, or tmin not below tmax",
                       n, counted(invalid_.size(), "ray"), n == 1 ? "is" : "are",
                       std::ranges::find(invalid_, true) - invalid_.begin());
}

std::vector<Ray> TraceCheck::failed_rays() const {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < asked_.size(); ++i)
        if (failed_[i]) rays.push_back(asked_[i]);
    return rays;
}

}  // namespace kd
