#include "renderer/measure/error_time/effect_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/double_path.h"
#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/ranking.h"
#include "renderer/measure/error_time/reference_image.h"
#include "renderer/measure/error_time/relative_error.h"
#include "renderer/measure/error_time/sampling.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

constexpr unsigned reference_seed = 0x5eed0000;

/// Of the first sets of samples and of the reference's halves: none of one is one of another.
unsigned seed_of_set(unsigned seed, int set) { return 1000 * seed + unsigned(set); }

/// What one set of samples came to, per number of samples.
struct SetErrors {
    std::vector<double> relative, mean_squares;
};

/// Adaptive sampling to one error, per set.
struct AdaptiveRuns {
    SetErrors errors;
    std::vector<double> ms, average_samples;
    bool paused = false;
};

/// A line through squares is one through roots, twice as steep.
PowerFit of_squares(PowerFit roots) {
    return {
        2 * roots.slope, roots.scale * roots.scale, {2 * roots.interval.low, 2 * roots.interval.high}, roots.points};
}

std::vector<double> column(const std::vector<SetErrors>& sets, std::vector<double> SetErrors::*what, std::size_t i) {
    std::vector<double> values;
    for (const SetErrors& set : sets) values.push_back((set.*what)[i]);
    return values;
}

double gap_between(const SetErrors& a, const SetErrors& b) {
    double gap = 0;
    for (std::size_t i = 0; i < a.mean_squares.size(); ++i)
        gap = std::max(gap, std::abs(std::sqrt(a.mean_squares[i]) - std::sqrt(b.mean_squares[i])));
    return gap;
}

void judge_point(EffectPoint& point, const std::vector<double>& relative, const std::vector<double>& mean_squares) {
    point.relative_mse = mean_over_sets(relative);
    point.relative_mse_interval = mean_interval(relative);
    point.rmse = std::sqrt(mean_over_sets(mean_squares));
}

void fill(EffectCurve& curve, const std::vector<SetErrors>& sets) {
    std::vector<double> samples;
    SquaredErrors squares;
    for (const SetErrors& set : sets) squares.push_back(set.relative);
    for (std::size_t i = 0; i < sets.front().relative.size(); ++i) {
        EffectPoint point;
        point.samples = 1 << i;
        point.average_samples = point.samples;
        const double scale = 1e-3 * point.samples;
        point.seconds = scale * curve.frame.median_ms;
        point.quartiles = {scale * curve.frame.p25_ms, scale * curve.frame.p75_ms};
        judge_point(point, column(sets, &SetErrors::relative, i), column(sets, &SetErrors::mean_squares, i));
        samples.push_back(point.samples);
        curve.points.push_back(point);
    }
    curve.fit = of_squares(fit_power_over_sets(samples, squares));
}

EffectPoint adaptive_point(double error, int samples, const AdaptiveRuns& runs) {
    EffectPoint point;
    point.samples = samples;
    point.average_samples = mean_over_sets(runs.average_samples);
    point.asked_error = error;
    const TimeSummary time = summarise(runs.ms);
    point.seconds = 1e-3 * time.median_ms;
    point.quartiles = {1e-3 * time.p25_ms, 1e-3 * time.p75_ms};
    judge_point(point, runs.errors.relative, runs.errors.mean_squares);
    return point;
}

/// Machines that make one picture differ by rounding, which is no reason for a place on the front.
TimeAndError time_and_error(const EffectPoint& point) {
    constexpr double steps = 1e5;  // of the logarithm: far above the 1e-8 of rounding, far below any whisker
    return {point.seconds, std::round(steps * std::log(std::max(point.relative_mse, 1e-300)))};
}

/// Of all sets of an effect by both samplers.
std::int64_t frames_of(const EffectPlan& plan, std::size_t methods) {
    return 2 * std::int64_t(plan.most_samples) * (std::int64_t(methods) + plan.sets - 1);
}

class EffectRun {
  public:
    struct Stopped {};

    EffectRun(const EffectTask& task, const std::function<void(float, const std::string&)>& progress,
              const std::stop_token& stop)
        : task_(task), progress_(progress), stop_(stop),
          camera_(effect_camera(task.scene, task.plan.width, task.plan.height)) {}

    void measure(EffectReport& report) {
        for (const LightEffect& effect : task_.effects) {
            MeasuredEffect measured{.effect = effect, .curves = {}};
            const ReferenceImage reference = reference_of(effect);
            reference_ = &reference.mean;
            measured.reference_rmse = reference.rmse;
            measured.reference_relative_mse = reference.relative_mse;
            const std::vector<TimedRounds> frames = time_frames(effect);
            for (const LightPoints points : {LightPoints::sequence, LightPoints::independent})
                measure_points(effect, points, frames, measured);
            if (&effect == &task_.effects.back()) measure_adaptive(effect, frames, measured);
            mark_front(measured.curves, time_and_error, &EffectPoint::on_front);
            report.effects.push_back(std::move(measured));
            ++done_;
            traced_ = 0;
        }
    }

  private:
    void check_stop() const {
        if (stop_.stop_requested()) throw Stopped{};
    }
    /// `fraction` of the effect at hand.
    void tell(float fraction, const LightEffect& effect, const std::string& what) const {
        check_stop();
        if (progress_)
            progress_((float(done_) + fraction) / float(task_.effects.size()),
                      fmt::format("{}: {}", effect.name, what));
    }

    [[nodiscard]] TraceConfig config_of(const LightEffect& effect, int sample, unsigned seed) const {
        TraceConfig config = task_.config;
        config.sampling = effect.sampling;
        config.sampling.sample = sample;
        config.sampling.seed = seed;
        return config;
    }

    [[nodiscard]] ReferenceImage reference_of(const LightEffect& effect) const {
        const int width = task_.plan.width, height = task_.plan.height;
        const auto frame = [&](int half, int sample) {
            const TraceConfig config = config_of(effect, sample, reference_seed ^ seed_of_set(task_.seed, half));
            return double_frame(task_.scene, camera_, width, height, path_config(task_.scene, config), task_.threads,
                                stop_, &task_.boxes);
        };
        const auto told = [&](float done) { tell(0.4f * done, effect, "the reference in double precision"); };
        ReferenceImage reference = reference_of_halves(width, height, task_.plan.reference_samples, frame, told, stop_);
        check_stop();
        return reference;
    }

    [[nodiscard]] std::vector<TimedRounds> time_frames(const LightEffect& effect) {
        const TraceConfig config = config_of(effect, 0, seed_of_set(task_.seed, 0));
        std::vector<Contestant> contestants;
        for (const EffectMethod& method : task_.methods)
            contestants.push_back({method.machine, [&, this] {
                                       tell(0.4f, effect, "frames of all methods in turn");
                                       return method.trace(config, colour_);
                                   }});
        return time_in_turn(contestants, rounds_within(task_.frame_seconds));
    }

    void measure_points(const LightEffect& effect, LightPoints points, const std::vector<TimedRounds>& frames,
                        MeasuredEffect& measured) {
        std::vector<SetErrors> sets(1);
        for (int set = 1; set < task_.plan.sets; ++set)
            sets.push_back(trace_set(task_.methods.front(), effect, points, set));
        SetErrors of_first;
        for (std::size_t m = 0; m < task_.methods.size(); ++m) {
            const EffectMethod& method = task_.methods[m];
            sets.front() = trace_set(method, effect, points, 0);
            if (m == 0) of_first = sets.front();
            EffectCurve curve{points, method.machine, method.clock, frames[m].total(), {}, {}};
            fill(curve, sets);
            curve.gap = gap_between(sets.front(), of_first);
            measured.curves.push_back(std::move(curve));
        }
    }

    SetErrors trace_set(const EffectMethod& method, const LightEffect& effect, LightPoints points, int set) {
        SetErrors errors;
        SampleMean mean(task_.plan.width, task_.plan.height);
        const auto all = float(frames_of(task_.plan, task_.methods.size()));
        const unsigned seed = seed_of_set(task_.seed, set);
        Random random(seed);
        for (int i = 0; i < task_.plan.most_samples; ++i) {
            const int sample = points == LightPoints::sequence ? i : int(random.next() >> 33);
            const TraceConfig config = config_of(effect, sample, seed);
            method.trace(config, colour_);
            mean.add(colour_);
            tell(0.4f + 0.5f * float(++traced_) / all, effect, fmt::format("samples on {}", method.machine));
            if ((mean.samples() & (mean.samples() - 1)) == 0) judge(mean, errors);
        }
        return errors;
    }

    void judge(const SampleMean& mean, SetErrors& errors) const {
        const Image<glm::dvec3> image = mean.mean();
        errors.relative.push_back(relative_mean_square_error(image, *reference_));
        errors.mean_squares.push_back(mean_square_error(image, *reference_));
    }

    void measure_adaptive(const LightEffect& effect, const std::vector<TimedRounds>& frames, MeasuredEffect& measured) {
        for (std::size_t m = 0; m < task_.methods.size(); ++m) {
            const EffectMethod& method = task_.methods[m];
            EffectCurve curve{LightPoints::adaptive, method.machine, method.clock, frames[m].total(), {}, {}};
            for (const double error : adaptive_errors) {
                tell(0.9f, effect, fmt::format("tiles pause at a standard error of {} on {}", error, method.machine));
                const AdaptiveRuns runs = run_adaptive(method, effect, error);
                if (!runs.paused) break;  // nor at a smaller error
                curve.points.push_back(adaptive_point(error, task_.plan.most_samples, runs));
            }
            if (!curve.points.empty()) measured.curves.push_back(std::move(curve));
        }
    }

    /// Of the same seeds as the sequence's own sets.
    AdaptiveRuns run_adaptive(const EffectMethod& method, const LightEffect& effect, double error) const {
        AdaptiveRuns runs;
        for (int set = 0; set < task_.plan.sets; ++set) {
            const TraceConfig config = config_of(effect, 0, seed_of_set(task_.seed, set));
            const GatheredImage gathered = method.gather(config, task_.plan.most_samples, error);
            check_stop();
            SampleMean mean(task_.plan.width, task_.plan.height);
            mean.add(gathered.colour);
            judge(mean, runs.errors);
            runs.ms.push_back(gathered.ms);
            runs.average_samples.push_back(gathered.average_samples);
            runs.paused = runs.paused || gathered.paused;
        }
        return runs;
    }

    const EffectTask& task_;
    const std::function<void(float, const std::string&)>& progress_;
    const std::stop_token& stop_;
    PinholeCamera camera_;
    Image<Vec4> colour_;
    std::int64_t traced_ = 0;
    std::size_t done_ = 0;
    const Image<glm::dvec3>* reference_ = nullptr;
};

double predicted_seconds(const EffectPlan& plan, const std::vector<EffectCost>& costs, int probe_pixels) {
    double ms = 0;
    for (const EffectCost& cost : costs) {
        ms += plan.reference_samples * cost.reference_ms;
        for (const double each : cost.method_ms) ms += 2 * plan.most_samples * each;
        ms += 2 * (plan.sets - 1) * plan.most_samples * cost.method_ms.front();
    }
    // Half of all samples, as far as anybody can know: some tiles pause at once, others never.
    for (const double each : costs.back().method_ms)
        ms += 0.5 * double(adaptive_errors.size()) * plan.sets * plan.most_samples * each;
    return 1e-3 * ms * plan.width * plan.height / probe_pixels;
}

}  // namespace

std::vector<LightEffect> light_effects(const FlatScene& scene, TraceConfig config) {
    config.sampling = {.sample = 0};
    const SceneNeeds needs = scene_needs(scene, KdTree{}, config);
    std::vector<LightEffect> effects;
    const auto add = [&](bool there, const char* name, const Sampling& sampling) {
        if (there) effects.push_back({name, sampling});
    };
    add(needs.soft_shadows, "soft shadows", {.gloss = false, .indirect = false});
    add(needs.gloss, "gloss", {.soft_shadows = false, .indirect = false});
    add(needs.indirect, "indirect light", {.soft_shadows = false, .gloss = false});
    add(effects.size() > 1, "all effects", {});
    return effects;
}

PinholeCamera effect_camera(const FlatScene& scene, int width, int height) {
    // No fraction of small numbers, so that no edge at such a fraction meets it.
    constexpr glm::dvec2 off_in_pixels{0.1234, 0.3141};
    return shifted(pinhole(scene.camera, width, height), off_in_pixels, width, height);
}

EffectPlan plan_effects(double seconds, const std::vector<EffectCost>& costs, int probe_pixels) {
    struct Choice {
        int side, samples, reference, sets;
    };
    // From the best to the cheapest. Tiles of 32 pixels take an image of several to show what pausing them saves.
    constexpr Choice choices[] = {{256, 256, 2048, 8}, {192, 256, 2048, 6}, {128, 256, 2048, 6}, {128, 128, 1024, 6},
                                  {128, 64, 1024, 4},  {128, 64, 512, 4},   {96, 64, 512, 4},    {96, 32, 256, 4},
                                  {64, 32, 256, 4},    {48, 16, 128, 4},    {32, 16, 128, 4},    {32, 8, 64, 3}};
    EffectPlan plan;
    for (const Choice& choice : choices) {
        plan = {choice.side, choice.side, choice.samples, choice.reference, choice.sets, 0};
        plan.predicted_seconds = predicted_seconds(plan, costs, probe_pixels);
        if (plan.predicted_seconds <= seconds) break;
    }
    return plan;
}

EffectReport report_effects(const EffectTask& task, const std::function<void(float, const std::string&)>& progress,
                            const std::stop_token& stop) {
    EffectReport report;
    report.plan = task.plan;
    try {
        EffectRun(task, progress, stop).measure(report);
        report.complete = true;
    } catch (const EffectRun::Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
