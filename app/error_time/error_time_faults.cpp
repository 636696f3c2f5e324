#include "app/error_time/error_time_faults.h"

#include <fmt/format.h>

namespace kd {

namespace {

void add_image_faults(const SceneErrorTime& scene, std::vector<ErrorTimeFault>& faults) {
    for (const std::string& machine : scene.images->machines())
        if (const double gap = scene.images->own_gap(machine); !(gap <= ImageReport::most_own_gap))
            faults.push_back({ErrorReport::p1, scene.name.shown,
                              fmt::format("traversals on {} differ in RMSE by up to {:.1e}; up to {:.0e} is rounding",
                                          machine, gap, ImageReport::most_own_gap)});
}

void add_hit_faults(const HitReport& report, std::vector<ErrorTimeFault>& faults) {
    for (const HitRow& row : report.rows)
        if (row.at_fault())
            faults.push_back({ErrorReport::p2, row.family,
                              fmt::format("{}, {}: {} of {} rays are missed or wrong", row.method.family_name(),
                                          info(row.method.traversal).name, row.missed + row.wrong, row.n)});
}

void add_truncation_faults(const SceneErrorTime& scene, std::vector<ErrorTimeFault>& faults) {
    for (const TruncationCurve& curve : scene.truncation->curves)
        for (const int limit : curve.wrong_limits())
            faults.push_back({ErrorReport::p5, scene.name.shown,
                              fmt::format("{} on {}: a budget of {} steps gives up no ray and changes the image",
                                          curve.traversal, curve.machine, limit)});
}

void add_cost_faults(const SceneErrorTime& scene, std::vector<ErrorTimeFault>& faults) {
    for (const TreeRow& row : scene.trees->rows)
        if (row.line_ratios.verdict() == LineVerdict::wrong)
            faults.push_back({ErrorReport::p3, scene.name.shown,
                              fmt::format("{}: what lines pay is off the prediction by {:.2f} %", row.name(),
                                          100 * row.line_ratios.error())});
}

}  // namespace

std::string ErrorTimeFault::where() const {
    return fmt::format("{} of {}", error_report_names[std::size_t(report)], of);
}

std::vector<ErrorTimeFault> faults_of(const ErrorTimeResults& results) {
    std::vector<ErrorTimeFault> faults;
    for (const SceneErrorTime& scene : results.scenes) {
        if (scene.images) add_image_faults(scene, faults);
        if (scene.truncation) add_truncation_faults(scene, faults);
        if (scene.trees && results.config.wants(ErrorReport::p3)) add_cost_faults(scene, faults);
    }
    if (results.hits) add_hit_faults(*results.hits, faults);
    return faults;
}

}  // namespace kd
