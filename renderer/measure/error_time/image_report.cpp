#include "renderer/measure/error_time/image_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "renderer/measure/double_path.h"
#include "renderer/measure/error_time/flip.h"
#include "renderer/measure/error_time/image_error.h"
#include "renderer/measure/error_time/ranking.h"

namespace kd {

namespace {

constexpr std::array samplers{Sampler::regular, Sampler::independent, Sampler::stratified};
constexpr std::uint64_t reference_seed = 0x5eed0000;

int level_count(int most_samples) { return int(std::lround(std::log2(most_samples))) + 1; }

/// Frames that one set of a sampler takes for all numbers of samples up to `most`: nested ones share theirs.
int frames_of_set(Sampler sampler, int most) { return sampler == Sampler::independent ? most : 2 * most - 1; }

std::uint64_t set_seed(unsigned seed, Sampler sampler, int set, int level) {
    return (std::uint64_t(seed) << 32) + (std::uint64_t(sampler) << 24) + (std::uint64_t(level) << 16) +
           std::uint64_t(set);
}

/// What one set of samples came to, per number of samples.
struct SetErrors {
    std::vector<double> mean_squares, flips;
};

/// The largest difference of own_rmse.
double gap_between(const ImageCurve& a, const ImageCurve& b) {
    double gap = 0;
    for (std::size_t i = 0; i < std::min(a.points.size(), b.points.size()); ++i)
        gap = std::max(gap, std::abs(a.points[i].own_rmse - b.points[i].own_rmse));
    return gap;
}

class ImageRun {
  public:
    struct Stopped {};

    ImageRun(const ImageTask& task, const std::function<void(float, const std::string&)>& progress,
             std::stop_token stop)
        : task_(task), progress_(progress), stop_(std::move(stop)),
          camera_(pinhole(task.scene.camera, task.plan.width, task.plan.height)) {}

    void measure(ImageReport& report) {
        const auto told = [this](float done) { tell(0.4f * done, "the reference in double precision"); };
        const ReferenceImage reference = reference_image(task_, told, stop_);
        check_stop();
        report.reference_rmse = reference.rmse;
        reference_ = &reference.mean;
        const Flip flip(reference.mean);
        flip_ = &flip;
        const std::vector<TimedRounds> frames = time_frames();
        for (const Sampler sampler : samplers) measure_sampler(sampler, frames, report);
        mark_front(
            report.curves,
            [](const ImagePoint& point) {
                return TimeAndError{point.seconds, point.rmse};
            },
            &ImagePoint::on_front);
    }

  private:
    void check_stop() const {
        if (stop_.stop_requested()) throw Stopped{};
    }
    void tell(float fraction, const std::string& what) const {
        if (progress_) progress_(fraction, what);
    }

    [[nodiscard]] std::vector<TimedRounds> time_frames() {
        std::vector<Contestant> contestants;
        for (const ImageMethod& method : task_.methods)
            contestants.push_back({method.machine, [&, this] {
                                       check_stop();
                                       tell(0.4f, "frames of all methods in turn");
                                       return method.trace(camera_, colour_);
                                   }});
        return time_in_turn(contestants, rounds_within(task_.frame_seconds));
    }

    void measure_sampler(Sampler sampler, const std::vector<TimedRounds>& frames, ImageReport& report) {
        const int sets = sampler == Sampler::regular ? 1 : task_.plan.sets;
        std::vector<SetErrors> further;
        for (int set = 1; set < sets; ++set) further.push_back(trace_set(task_.methods.front(), sampler, set));
        const std::ptrdiff_t first = std::ssize(report.curves);
        for (std::size_t m = 0; m < task_.methods.size(); ++m) {
            const ImageMethod& method = task_.methods[m];
            ImageCurve curve{.sampler = sampler,
                             .machine = method.machine,
                             .traversal = method.traversal,
                             .clock = method.clock,
                             .frame = frames[m].total(),
                             .clock_discrepancy = frames[m].clock_discrepancy(),
                             .of_first = ratio_interval(frames[m].ms(), frames.front().ms()),
                             .points = {},
                             .fit = {}};
            std::vector<SetErrors> all{trace_set(method, sampler, 0)};
            all.insert(all.end(), further.begin(), further.end());
            fill(curve, all);
            report.curves.push_back(std::move(curve));
            ImageCurve& last = report.curves.back();
            const auto begin = report.curves.begin() + first;
            last.worst_gap = gap_between(last, *begin);
            last.own_gap =
                gap_between(last, *std::ranges::find(begin, report.curves.end(), method.machine, &ImageCurve::machine));
        }
    }

    SetErrors trace_set(const ImageMethod& method, Sampler sampler, int set) {
        const int levels = level_count(task_.plan.most_samples);
        SetErrors errors;
        if (sampler == Sampler::independent) {
            SampleMean mean(task_.plan.width, task_.plan.height);
            const auto offsets =
                sample_offsets(sampler, task_.plan.most_samples, set_seed(task_.seed, sampler, set, 0));
            for (const glm::dvec2 offset : offsets) {
                add_sample(method, offset, mean);
                if ((mean.samples() & (mean.samples() - 1)) == 0) judge(mean, errors);
            }
            return errors;
        }
        for (int level = 0; level < levels; ++level) {
            SampleMean mean(task_.plan.width, task_.plan.height);
            const auto offsets = sample_offsets(sampler, 1 << level, set_seed(task_.seed, sampler, set, level));
            for (const glm::dvec2 offset : offsets) add_sample(method, offset, mean);
            judge(mean, errors);
        }
        return errors;
    }

    void add_sample(const ImageMethod& method, glm::dvec2 offset, SampleMean& mean) {
        check_stop();
        method.trace(shifted(camera_, offset, task_.plan.width, task_.plan.height), colour_);
        check_stop();
        mean.add(colour_);
        tell(0.4f + 0.6f * float(++traced_) / float(all_frames()),
             fmt::format("samples by {} on {}", method.traversal, method.machine));
    }

    void judge(const SampleMean& mean, SetErrors& errors) const {
        const Image<glm::dvec3> image = mean.mean();
        errors.mean_squares.push_back(mean_square_error(image, *reference_));
        errors.flips.push_back(flip_->mean(image));
    }

    void fill(ImageCurve& curve, const std::vector<SetErrors>& all) const {
        SquaredErrors squares;
        for (const SetErrors& set : all) squares.push_back(set.mean_squares);
        const std::vector<double> roots = root_means(squares);
        std::vector<double> samples;
        for (std::size_t i = 0; i < roots.size(); ++i) {
            ImagePoint point;
            point.samples = 1 << i;
            samples.push_back(point.samples);
            const double scale = 1e-3 * point.samples;
            point.seconds = scale * curve.frame.median_ms;
            point.quartiles = {scale * curve.frame.p25_ms, scale * curve.frame.p75_ms};
            point.rmse = roots[i];
            point.rmse_interval = root_mean_interval(squares, i);
            point.own_rmse = std::sqrt(squares.front()[i]);
            std::vector<double> flips;
            for (const SetErrors& set : all) flips.push_back(set.flips[i]);
            point.flip = mean_over_sets(flips);
            point.flip_interval = mean_interval(flips);
            curve.points.push_back(point);
        }
        curve.fit = fit_power_over_sets(samples, squares);
    }

    [[nodiscard]] int all_frames() const {
        int frames = 0;
        for (const Sampler sampler : samplers)
            frames += frames_of_set(sampler, task_.plan.most_samples) *
                      (int(task_.methods.size()) + (sampler == Sampler::regular ? 0 : task_.plan.sets - 1));
        return frames;
    }

    const ImageTask& task_;
    const std::function<void(float, const std::string&)>& progress_;
    std::stop_token stop_;
    PinholeCamera camera_;
    Image<Vec4> colour_;
    int traced_ = 0;
    const Image<glm::dvec3>* reference_ = nullptr;
    const Flip* flip_ = nullptr;
};

double predicted_seconds(const ImagePlan& plan, const std::vector<double>& method_ms, double reference_ms,
                         int probe_pixels) {
    double ms = plan.reference_samples * reference_ms;
    for (const Sampler sampler : samplers) {
        const int frames = frames_of_set(sampler, plan.most_samples);
        for (const double each : method_ms) ms += frames * each;
        if (sampler != Sampler::regular && !method_ms.empty()) ms += (plan.sets - 1) * frames * method_ms.front();
    }
    return 1e-3 * ms * plan.width * plan.height / probe_pixels;
}

}  // namespace

ImagePlan plan_images(double seconds, const std::vector<double>& method_ms, double reference_ms, int probe_pixels) {
    struct Choice {
        int side, samples, reference, sets;
    };
    // From the best to the cheapest; what is measured has at most an eighth of the reference's samples.
    constexpr Choice choices[] = {{192, 256, 2048, 8}, {128, 256, 2048, 8}, {128, 128, 1024, 8}, {128, 64, 1024, 8},
                                  {128, 64, 512, 8},   {96, 64, 512, 8},    {64, 64, 512, 8},    {64, 32, 256, 8},
                                  {48, 16, 256, 6},    {32, 16, 128, 6},    {24, 8, 64, 4}};
    ImagePlan plan;
    for (const Choice& choice : choices) {
        plan = {choice.side, choice.side, choice.samples, choice.reference, choice.sets, 0};
        plan.predicted_seconds = predicted_seconds(plan, method_ms, reference_ms, probe_pixels);
        if (plan.predicted_seconds <= seconds) break;
    }
    return plan;
}

std::vector<std::string> ImageReport::machines() const {
    std::vector<std::string> names;
    for (const ImageCurve& curve : curves)
        if (std::ranges::find(names, curve.machine) == names.end()) names.push_back(curve.machine);
    return names;
}

double ImageReport::own_gap(const std::string& machine) const {
    double gap = 0;
    for (const ImageCurve& curve : curves)
        if (curve.machine == machine) gap = std::max(gap, curve.own_gap);
    return gap;
}

bool ImageReport::same_images() const {
    return std::ranges::all_of(curves, [](const ImageCurve& curve) { return curve.own_gap <= most_own_gap; });
}

ReferenceImage reference_image(const ImageTask& task, const std::function<void(float)>& progress,
                               const std::stop_token& stop) {
    const int width = task.plan.width, height = task.plan.height;
    const PinholeCamera camera = pinhole(task.scene.camera, width, height);
    const PathConfig path = path_config(task.scene, task.config);
    const int per_half = std::max(1, task.plan.reference_samples / 2);
    std::array<std::vector<glm::dvec2>, 2> offsets;
    for (std::size_t half = 0; half < offsets.size(); ++half)
        offsets[half] = sample_offsets(Sampler::stratified, per_half, reference_seed + task.seed + half);
    const auto frame = [&](int half, int sample) {
        const glm::dvec2 offset = offsets[std::size_t(half)][std::size_t(sample)];
        return double_frame(task.scene, shifted(camera, offset, width, height), width, height, path, task.threads, stop,
                            &task.boxes);
    };
    return reference_of_halves(width, height, 2 * per_half, frame, progress, stop);
}

ImageReport report_images(const ImageTask& task, const std::function<void(float, const std::string&)>& progress,
                          std::stop_token stop) {
    ImageReport report;
    report.plan = task.plan;
    try {
        ImageRun(task, progress, std::move(stop)).measure(report);
        report.complete = true;
    } catch (const ImageRun::Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
