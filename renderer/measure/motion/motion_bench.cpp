#include "renderer/measure/motion/motion_bench.h"

#include <algorithm>
#include <deque>
#include <fmt/format.h>

#include "renderer/kdtree/stats.h"
#include "renderer/measure/motion/tree_maker.h"
#include "renderer/measure/process_memory.h"

namespace kd {

namespace {

class Bench {
  public:
    Bench(const MovingScene& scene, const MotionBenchPlan& plan, const MotionTracing& tracing,
          const std::stop_token& stop, const std::function<void(float, const std::string&)>& progress)
        : scene_(scene), plan_(plan), tracing_(tracing), stop_(stop), progress_(progress) {
        for (const std::string& way : plan.ways) {
            makers_.emplace_back(way, plan.build, scene.at_rest().triangles, plan.build_threads);
            for (const FrameSchedule schedule : plan.schedules)
                bench_.rows.push_back({.schedule = schedule, .way = way});
        }
        // Before memory is looked at, so that it does not grow by what is measured.
        for (MotionRow& row : bench_.rows) reserve(row.stats);
    }

    MotionBench run() {
        const Frame first = first_frame();
        for (int round = 0; round < plan_.rounds && bench_.complete; ++round) {
            bench_.complete =
                take_turns(bench_.rows.size(), round, [&](std::size_t row) { return run_row(round, row); });
            if (round == 0) bench_.memory_begin = resident_bytes_in_use();
        }
        bench_.memory_end = resident_bytes_in_use();
        bench_.memory_peak = peak_resident_bytes();
        if (bench_.complete) bench_.first_frame_repeats = same_frame(first, first_frame());
        for (std::size_t i = 0; i < makers_.size() && bench_.complete; ++i) look_at_trees(makers_[i]);
        bench_.complete &= !stop_.stop_requested();
        return std::move(bench_);
    }

  private:
    void reserve(PipelineStats& stats) const {
        const auto take = [&](std::vector<double>& samples) {
            samples.resize(std::size_t(plan_.frames));  // written to: memory that is only reserved does not count yet
            samples.clear();
        };
        take(stats.frame_ms);
        take(stats.latency_ms);
        for (std::vector<double>& samples : stats.step_ms) take(samples);
    }

    [[nodiscard]] TreeMaker& maker_of(std::size_t row) { return makers_[row / plan_.schedules.size()]; }

    Frame first_frame() {
        const FlatScene scene = scene_.at(plan_.first_seconds);
        const KdTree tree = makers_.front().make(scene.triangles, stop_);
        tracing_.upload(scene, tree);
        (void)tracing_.trace(scene, stop_);
        return tracing_.frame();
    }

    [[nodiscard]] FrameStages stages_of(TreeMaker& maker) const {
        return {.update = [this](MotionFrame& f, const std::stop_token&) { f.scene = scene_.at(f.seconds); },
                .build = [&maker](MotionFrame& f,
                                  const std::stop_token& stop) { f.tree = maker.make(f.scene.triangles, stop); },
                .upload = [this](MotionFrame& f, const std::stop_token&) { tracing_.upload(f.scene, f.tree); },
                .trace = [this](MotionFrame& f, const std::stop_token& stop) { (void)tracing_.trace(f.scene, stop); }};
    }

    /// One row's frames of a round.
    bool run_row(int round, std::size_t index) {
        MotionRow& row = bench_.rows[index];
        const std::int64_t frames = plan_.frames;
        const int first = int(frames * round / plan_.rounds), last = int(frames * (round + 1) / plan_.rounds);
        const int warmup = std::max(plan_.warmup, 1);
        const PipelinePlan pipeline{.schedule = row.schedule,
                                    .frames = warmup + last - first,
                                    .first_seconds = plan_.first_seconds + (first - warmup) * plan_.step_seconds,
                                    .step_seconds = plan_.step_seconds};
        const std::string name = fmt::format("{}, {}", frame_schedule_names[std::size_t(row.schedule)], row.way);
        const double rows = double(bench_.rows.size()) * plan_.rounds;
        const auto tell = [&](int frame) {
            if (progress_) progress_(float((turns_ + double(frame) / pipeline.frames) / rows), name);
        };
        row.last = run_frames(pipeline, stages_of(maker_of(index)), stop_, tell);
        ++turns_;
        if (!row.last.complete) return false;
        const PipelineStats stats = pipeline_stats(row.last, warmup);
        row.stats.add(stats);
        row.round_ms.push_back(summarise(stats.frame_ms).median_ms);
        return true;
    }

    void look_at_trees(TreeMaker& maker) {
        WayQuality quality{.way = maker.way()};
        for (int i = 0; i < plan_.quality_samples && !stop_.stop_requested(); ++i) {
            const double seconds = plan_.first_seconds + plan_.step_seconds * double(plan_.frames - 1) * i /
                                                             std::max(plan_.quality_samples - 1, 1);
            const std::vector<Triangle> triangles = scene_.at(seconds).triangles;
            const auto cost = [&](const KdTree& tree) {
                return tree_stats(tree, triangles.size(), plan_.build).sah_cost;
            };
            const double own = cost(maker.make(triangles, stop_));
            const double fresh = cost(build_tree(triangles, plan_.build, nullptr, {}, stop_, plan_.build_threads));
            quality.seconds.push_back(seconds);
            quality.sah_cost.push_back(own);
            quality.loss.push_back(own / fresh - 1);
        }
        quality.refused = maker.refused();
        quality.why_refused = maker.why_refused();
        bench_.qualities.push_back(std::move(quality));
    }

    const MovingScene& scene_;
    const MotionBenchPlan& plan_;
    const MotionTracing& tracing_;
    const std::stop_token& stop_;
    const std::function<void(float, const std::string&)>& progress_;
    std::deque<TreeMaker> makers_;  // by way
    MotionBench bench_;
    int turns_ = 0;  // rows' rounds that are done
};

}  // namespace

const MotionRow* MotionBench::find(FrameSchedule schedule, const std::string& way) const {
    const auto found =
        std::ranges::find_if(rows, [&](const MotionRow& row) { return row.schedule == schedule && row.way == way; });
    return found == rows.end() ? nullptr : &*found;
}

const WayQuality* MotionBench::quality(const std::string& way) const {
    const auto found = std::ranges::find(qualities, way, &WayQuality::way);
    return found == qualities.end() ? nullptr : &*found;
}

MedianInterval MotionBench::of_serial(const MotionRow& row) const {
    const MotionRow* serial = find(FrameSchedule::serial, row.way);
    return serial && serial != &row ? ratio_interval(row.round_ms, serial->round_ms) : MedianInterval{};
}

std::optional<BreakEven> break_even(const MotionBench& bench, const MotionRow& row) {
    const MotionRow* first = bench.rows.empty() ? nullptr : bench.find(row.schedule, bench.rows.front().way);
    if (!first || first->way == row.way) return std::nullopt;
    const auto less = [&](FrameStep step) {
        const auto median = [&](const MotionRow& of) {
            return summarise(of.stats.step_ms[std::size_t(step)]).median_ms;
        };
        return median(*first) - median(row);
    };
    BreakEven even{.saved_build_ms = less(FrameStep::build), .lost_trace_ms = -less(FrameStep::trace)};
    if (even.saved_build_ms > 0 && even.lost_trace_ms > 0) even.times_rays = even.saved_build_ms / even.lost_trace_ms;
    return even;
}

MotionBench bench_motion(const MovingScene& scene, const MotionBenchPlan& plan, const MotionTracing& tracing,
                         const std::stop_token& stop, const std::function<void(float, const std::string&)>& progress) {
    return Bench(scene, plan, tracing, stop, progress).run();
}

}  // namespace kd
