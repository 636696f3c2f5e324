#include "renderer/measure/error_time/truncation_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/ranking.h"

namespace kd {

namespace {

/// The task's settings with nothing that ends a path or a walk but what the tracer itself cannot do without.
TraceConfig whole(const TruncationTask& task, const TruncationMethod& method) {
    TraceConfig config = task.config;
    config.traversal = method.walk;
    config.reflection_depth = task.deepest;
    config.step_budget = 0;
    return config;
}

TraceConfig limited(TraceConfig config, Truncation what, int limit) {
    (what == Truncation::reflection_depth ? config.reflection_depth : config.step_budget) = limit;
    return config;
}

std::vector<int> limits_of(Truncation what, int deepest) {
    std::vector<int> limits;
    if (what == Truncation::reflection_depth)
        for (int depth = 0; depth <= deepest; ++depth) limits.push_back(depth);
    else
        for (int budget = least_measured_budget; budget <= most_measured_budget; budget *= 2) limits.push_back(budget);
    return limits;
}

/// The share to which the errors fall from one bounce to the next, by the line through their logarithms.
double decay(const std::vector<TruncationPoint>& points) {
    std::vector<double> powers, errors;
    for (const TruncationPoint& point : points) {
        if (!(point.rmse > 0)) continue;
        powers.push_back(std::exp(double(point.limit)));
        errors.push_back(point.rmse);
    }
    return errors.size() < 3 ? 0 : std::exp(fit_power(powers, errors).slope);
}

void mark_front(TruncationReport& report, Truncation what) {
    std::vector<TimeAndError> all;
    std::vector<TruncationPoint*> points;
    for (TruncationCurve& curve : report.curves)
        if (curve.what == what)
            for (std::size_t i = 0; i < curve.telling_points(); ++i) {
                all.push_back({curve.points[i].frame.median_ms, curve.points[i].rmse});
                points.push_back(&curve.points[i]);
            }
    const std::vector<bool> front = pareto_front(all);
    for (std::size_t i = 0; i < points.size(); ++i) points[i]->on_front = front[i];
}

class TruncationRun {
  public:
    struct Stopped {};

    TruncationRun(const TruncationTask& task, const std::function<void(float, const std::string&)>& progress,
                  const std::stop_token& stop)
        : task_(task), progress_(progress), stop_(stop) {}

    void measure(TruncationReport& report) {
        std::set<std::string> seen;
        for (const TruncationMethod& method : task_.methods) {
            const bool first_of_machine = seen.insert(method.machine).second;
            if (task_.deepest > 0 && first_of_machine) judge(method, Truncation::reflection_depth, report);
            if (task_.budgets) judge(method, Truncation::step_budget, report);
        }
        time(report);
        for (const Truncation what : {Truncation::reflection_depth, Truncation::step_budget}) mark_front(report, what);
    }

  private:
    void tell(float fraction, const std::string& what) const {
        if (stop_.stop_requested()) throw Stopped{};
        if (progress_) progress_(fraction, what);
    }

    [[nodiscard]] Image<glm::dvec3> picture(const TruncationMethod& method, const TraceConfig& config) const {
        Image<Vec4> colour;
        (void)method.trace(config, colour);
        if (stop_.stop_requested()) throw Stopped{};
        SampleMean mean(colour.width, colour.height);
        mean.add(colour);
        return mean.mean();
    }

    void judge(const TruncationMethod& method, Truncation what, TruncationReport& report) {
        tell(0.5f * float(report.curves.size()) / float(2 * task_.methods.size()),
             fmt::format("{} by {} on {}", name_of(what), method.traversal, method.machine));
        const TraceConfig all = whole(task_, method);
        TruncationCurve curve{.what = what,
                              .machine = method.machine,
                              .traversal = method.traversal,
                              .clock = method.clock,
                              .points = {}};
        curve.most_steps = method.count(all).most_steps;
        const Image<glm::dvec3> reference = picture(method, all);
        for (const int limit : limits_of(what, task_.deepest)) {
            const TraceConfig config = limited(all, what, limit);
            TruncationPoint point{.limit = limit, .frame = {}};
            point.rmse = std::sqrt(mean_square_error(picture(method, config), reference));
            point.given_up = method.count(config).given_up;
            curve.points.push_back(point);
            timed_.push_back([&method, config, this] {
                tell(0.5f, "frames of all limits in turn");
                return method.trace(config, colour_);
            });
        }
        if (what == Truncation::reflection_depth) curve.per_bounce = decay(curve.points);
        report.curves.push_back(std::move(curve));
    }

    /// All points of all curves in turn, in their order.
    void time(TruncationReport& report) {
        std::vector<Contestant> contestants;
        for (const auto& run : timed_) contestants.push_back({"", run});
        const double left = std::max(0.0, task_.seconds - (steady_seconds() - begun_));
        const std::vector<TimedRounds> frames = time_in_turn(contestants, rounds_within(left));
        auto next = frames.begin();
        for (TruncationCurve& curve : report.curves)
            for (TruncationPoint& point : curve.points) point.frame = (next++)->total();
    }

    const TruncationTask& task_;
    const std::function<void(float, const std::string&)>& progress_;
    const std::stop_token& stop_;
    double begun_ = steady_seconds();
    std::vector<std::function<TimeSample()>> timed_;
    Image<Vec4> colour_;
};

}  // namespace

std::size_t TruncationCurve::telling_points() const {
    const auto exact = std::ranges::find(points, 0.0, &TruncationPoint::rmse);
    return std::size_t(exact - points.begin()) + (exact == points.end() ? 0 : 1);
}

std::vector<int> TruncationCurve::wrong_limits() const {
    std::vector<int> wrong;
    if (what == Truncation::step_budget)
        for (const TruncationPoint& point : points)
            if (point.given_up == 0 && point.rmse != 0) wrong.push_back(point.limit);
    return wrong;
}

TruncationReport report_truncation(const TruncationTask& task,
                                   const std::function<void(float, const std::string&)>& progress,
                                   const std::stop_token& stop) {
    TruncationReport report{task.width, task.height, task.deepest, task.largest_reflectance, {}, false};
    try {
        TruncationRun(task, progress, stop).measure(report);
        report.complete = true;
    } catch (const TruncationRun::Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
