#include "renderer/measure/error_time/tree_report.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/measure/error_time/break_even.h"
#include "renderer/measure/error_time/lines.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

constexpr std::array leaf_sizes{1, 2, 8};
constexpr std::array other_bins{4, 8, 16, 64, 256};
constexpr std::string_view best_builder = "exact";
constexpr std::size_t line_sets = 40;  // whose spread gives the intervals

struct Stopped {};

void check(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Stopped{};
}

double ratio(double a, double b) { return b > 0 ? a / b : 1; }

class TreeRun {
  public:
    TreeRun(const TreeTask& task, TreeReport& report, const std::function<void(float, const std::string&)>& progress,
            std::stop_token stop)
        : task_(task), report_(report), progress_(progress), stop_(std::move(stop)) {
        for (const Builder& builder : builders())
            for (const int leaf_size : leaf_sizes) {
                BuildConfig config = task.build;
                config.builder = builder.name;
                config.leaf_size = leaf_size;
                configs_.push_back(config);
            }
        for (const Builder& builder : builders())
            for (const int bins : other_bins) {
                if (!builder.has_bins || bins == task.build.bins) continue;
                BuildConfig config = task.build;
                config.builder = builder.name;
                config.leaf_size = BuildConfig{}.leaf_size;
                config.bins = bins;
                configs_.push_back(config);
            }
        report_.width = task.width;
        report_.height = task.height;
    }

    void measure() {
        time_builds();
        const PinholeCamera camera = pinhole(task_.scene.camera, task_.width, task_.height);
        report_.rays = count_rays(task_.scene, trees_.front(), task_.trace, camera, task_.width, task_.height);
        for (std::size_t i = 0; i < trees_.size(); ++i) count_cells(i, camera);
        time_frames(camera);
        compare();
    }

  private:
    void tell(float fraction, const std::string& what) const {
        if (progress_) progress_(fraction, what);
    }

    KdTree build(const BuildConfig& config, BuildReport& report) {
        check(stop_);
        KdTree tree = build_tree(task_.scene.triangles, config, &report, {}, stop_, task_.threads);
        check(stop_);
        return tree;
    }

    void time_builds() {
        std::vector<Contestant> contestants;
        for (const BuildConfig& config : configs_) {
            BuildReport built;
            tell(0, "building: " + config.builder);
            trees_.push_back(build(config, built));
            TreeRow row;
            row.builder = config.builder;
            row.leaf_size = config.leaf_size;
            const Builder* builder = find_builder(config.builder);
            row.bins = builder && builder->has_bins && config.bins != task_.build.bins ? config.bins : 0;
            row.stats = tree_stats(trees_.back(), task_.scene.triangles.size(), config);
            row.cap_hit = built.reference_cap_hit;
            report_.rows.push_back(std::move(row));
            contestants.push_back({config.builder, [&, this] {
                                       tell(0.1f, "builds of all trees in turn");
                                       BuildReport again;
                                       (void)build(config, again);
                                       return TimeSample{1e3 * again.seconds};
                                   }});
        }
        const auto timed = time_in_turn(contestants, rounds_within(task_.build_seconds));
        for (std::size_t i = 0; i < timed.size(); ++i) {
            report_.rows[i].build = timed[i].total();
            build_samples_.push_back(timed[i].ms());
        }
    }

    void count_cells(std::size_t i, const PinholeCamera& camera) {
        check(stop_);
        tell(0.3f + 0.3f * float(i) / float(trees_.size()), "cells on the way of lines and rays");
        TreeRow& row = report_.rows[i];
        Random random(task_.seed);
        const std::vector<Ray> lines = uniform_lines(trees_[i].bounds, task_.lines, random);
        const WalkScene scene(task_.scene, trees_[i]);
        const double traversal = double(task_.build.traversal_cost), test = double(task_.build.intersection_cost);
        std::vector<PassedCells> sets;
        const std::size_t count = std::min(line_sets, lines.size());
        for (std::size_t set = 0; set < count; ++set) {
            const std::size_t from = set * lines.size() / count, to = (set + 1) * lines.size() / count;
            sets.push_back(pass_cells(scene, std::span(lines).subspan(from, to - from), traversal, test));
        }
        row.lines = sum_of(sets);
        row.line_ratios = line_ratios(sets, row.stats, task_.seed);
        TraceConfig counted = task_.trace;
        counted.counters = true;
        Frame frame(task_.width, task_.height);
        CpuTracer tracer(task_.scene, trees_[i]);
        tracer.trace_frame(counted, camera, frame, task_.threads, stop_);
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            if (report_.rays[pass] == 0) continue;
            CounterTotals totals;
            for (const RayCounters& c : frame.layers[pass].counters.pixels) totals.add(c);
            const double visits = double(totals.interior_first + totals.interior_again);
            row.cost_per_ray[pass] =
                (traversal * visits + test * double(totals.triangle_tests)) / double(report_.rays[pass]);
        }
    }

    void time_frames(const PinholeCamera& camera) {
        std::vector<CpuTracer> tracers;
        for (const KdTree& tree : trees_) tracers.emplace_back(task_.scene, tree);
        TraceConfig plain = task_.trace;
        plain.counters = false;
        Frame frame(task_.width, task_.height);
        std::vector<Contestant> contestants;
        for (CpuTracer& tracer : tracers)
            contestants.push_back({"", [&, this] {
                                       check(stop_);
                                       return TimeSample{wall_ms(
                                           [&] { tracer.trace_frame(plain, camera, frame, task_.threads, stop_); })};
                                   }});
        const TimingPlan plan = rounds_within(task_.frame_seconds);
        const auto round_done = [&](int rounds, const auto&) {
            tell(0.6f + 0.4f * float(rounds) / float(plan.rounds), "frames of all trees in turn");
        };
        const auto timed = time_in_turn(contestants, plan, round_done);
        for (std::size_t i = 0; i < timed.size(); ++i) {
            report_.rows[i].frame = timed[i].total();
            frame_samples_.push_back(timed[i].ms());
        }
    }

    [[nodiscard]] std::size_t reference_row() const {
        const int usual = BuildConfig{}.leaf_size;
        for (std::size_t i = 0; i < report_.rows.size(); ++i)
            if (report_.rows[i].builder == best_builder && report_.rows[i].leaf_size == usual) return i;
        const auto least =
            std::ranges::min_element(report_.rows, {}, [](const TreeRow& r) { return r.stats.sah_cost; });
        return std::size_t(least - report_.rows.begin());
    }

    [[nodiscard]] TreeRounds rounds_of(std::size_t i) const { return {build_samples_[i], frame_samples_[i]}; }

    void compare() {
        report_.reference = reference_row();
        const TreeRow best = report_.rows[report_.reference];
        std::vector<TimeAndError> all;
        for (std::size_t i = 0; i < report_.rows.size(); ++i) {
            TreeRow& row = report_.rows[i];
            row.sah_ratio = ratio(row.stats.sah_cost, best.stats.sah_cost);
            row.frame_ratio = ratio_interval(frame_samples_[i], frame_samples_[report_.reference]);
            row.break_even_frames =
                break_even(row.build.median_ms, best.build.median_ms, best.frame.median_ms, row.frame_ratio);
            if (row.break_even_frames)
                row.break_even_interval = break_even_interval(rounds_of(i), rounds_of(report_.reference), task_.seed);
            all.push_back({row.build.median_ms, row.frame.median_ms});
        }
        const std::vector<bool> front = pareto_front(all);
        for (std::size_t i = 0; i < front.size(); ++i) report_.rows[i].on_front = front[i];
        correlate();
    }

    void correlate() {
        std::vector<double> predicted, frames;
        for (const TreeRow& row : report_.rows) {
            predicted.push_back(row.stats.sah_cost);
            frames.push_back(row.frame.median_ms);
        }
        report_.frame_tau = rank_correlation(predicted, frames, task_.seed);
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            if (report_.rays[pass] == 0) continue;
            std::vector<double> costs;
            for (const TreeRow& row : report_.rows) costs.push_back(row.cost_per_ray[pass]);
            report_.tau[pass] = rank_correlation(predicted, costs, task_.seed);
        }
    }

    const TreeTask& task_;
    TreeReport& report_;
    const std::function<void(float, const std::string&)>& progress_;
    std::stop_token stop_;
    std::vector<BuildConfig> configs_;
    std::vector<KdTree> trees_;
    std::vector<std::vector<double>> build_samples_, frame_samples_;  // ms, by row and round
};

}  // namespace

std::string TreeRow::name() const {
    return fmt::format("{}{}, leaves of {}", builder, bins > 0 ? fmt::format(", {} bins", bins) : "", leaf_size);
}

double TreeReport::line_error() const {
    double most = 0;
    for (const TreeRow& row : rows) most = std::max(most, row.line_ratios.error());
    return most;
}

LineVerdict TreeReport::line_verdict() const {
    LineVerdict verdict = LineVerdict::right;
    for (const TreeRow& row : rows) {
        const LineVerdict one = row.line_ratios.verdict();
        if (one == LineVerdict::wrong) return one;
        if (one == LineVerdict::open) verdict = one;
    }
    return verdict;
}

TreeReport report_trees(const TreeTask& task, const std::function<void(float, const std::string&)>& progress,
                        std::stop_token stop) {
    TreeReport report;
    try {
        TreeRun(task, report, progress, std::move(stop)).measure();
        report.complete = true;
    } catch (const Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
