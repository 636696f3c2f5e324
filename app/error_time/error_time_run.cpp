#include "app/error_time/error_time_run.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/cli/command.h"
#include "app/error_time/frame_reports.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

constexpr std::size_t least_triangles = 65;  // below it no tree is worth building

/// The share of the time that a report gets when all are made.
double share_of(ErrorReport report) {
    switch (report) {
        case ErrorReport::p1: return 0.6;
        case ErrorReport::p2: return 0.2;
        case ErrorReport::p6: return 0.4;
        default: return 0.1;
    }
}

/// What the rows name themselves; how large images are, scenes.csv tells.
constexpr std::initializer_list<const char*> varied{"scene", "width", "height", "tracer", "traversal"};

class Run {
  public:
    Run(const ErrorTimeConfig& config, const std::vector<OpenedScene>& scenes, const ReportProgress& progress,
        const std::stop_token& stop)
        : config_(config), scenes_(scenes), progress_(progress), stop_(stop) {
        for (const ErrorReport report : config.reports) all_shares_ += share_of(report);
    }

    ErrorTimeResults measure() {
        const Session& first = scenes_.front().session;
        std::vector<std::string> given;
        for (const OpenedScene& opened : scenes_) given.push_back(opened.session.scene);
        const std::vector<ReportName> names = report_names(given);
        results_.config = config_;
        results_.on = measured_on(first, varied);
        results_.seconds = 1e-3 * wall_ms([&] {
                               for (std::size_t i = 0; i < scenes_.size(); ++i)
                                   results_.scenes.push_back(measure_scene(scenes_[i], names[i]));
                               if (config_.wants(ErrorReport::p2)) results_.hits = measure_hits();
                           });
        return std::move(results_);
    }

  private:
    /// Seconds for a report of one scene, or of all scenes.
    [[nodiscard]] double seconds_for(ErrorReport report, bool of_all) const {
        const double seconds = config_.seconds * share_of(report) / all_shares_;
        return of_all ? seconds : seconds / double(std::max<std::size_t>(scenes_.size(), 1));
    }

    /// Progress of a part that takes `share` of the whole, after those before it.
    ReportProgress part(double share) {
        const double from = done_;
        done_ += share;
        return [this, from, share](float fraction, const std::string& what) {
            progress_(float(from + share * double(fraction)), what);
        };
    }

    void check() const {
        if (stop_.stop_requested()) throw Interrupted();
    }

    SceneErrorTime measure_scene(const OpenedScene& opened, const ReportName& name) {
        SceneErrorTime result;
        result.session = opened.session;
        result.contents = contents_text(opened.scene) + (opened.session.trace.shadows ? "" : ", no shadow rays");
        result.name = name;
        const bool trees = config_.wants(ErrorReport::p3) || config_.wants(ErrorReport::p4);
        if (!config_.wants_machines() && !trees) return result;
        const KdTree tree =
            build_tree(opened.scene.triangles, opened.session.build, nullptr, {}, stop_, opened.session.threads);
        check();
        if (config_.wants_machines()) measure_frames(opened, tree, result);
        if (trees) measure_trees(opened, tree, result, scene_part(ErrorReport::p3, ErrorReport::p4));
        return result;
    }

    /// Progress of one scene's part of these reports.
    template <class... Reports>
    ReportProgress scene_part(Reports... reports) {
        return part(((config_.wants(reports) ? share_of(reports) : 0) + ...) / double(scenes_.size()) / all_shares_);
    }

    void measure_frames(const OpenedScene& opened, const KdTree& tree, SceneErrorTime& result) {
        const auto leave_out = [&](const std::string& why) {
            for (const ErrorReport report : config_.reports)
                if (traces_by_machines(report)) result.left_out.push_back({report, why});
        };
        if (opened.scene.triangles.empty()) {
            leave_out("the scene has no triangles, so every sample is the same");
            return;
        }
        const auto missing = [&](const std::string& machine, const std::string& why) {
            leave_out(fmt::format("{}: {}", machine, why));
        };
        progress_(float(done_), fmt::format("{}: a first look", opened.session.scene));
        std::vector<FrameMachine> machines = open_machines(config_, opened, tree, missing, stop_);
        if (machines.empty()) return;
        for (const FrameMachine& machine : machines)
            if (!runs_on_cpu(machine.kind))
                results_.on = measured_on(scenes_.front().session, varied, machine.tracer.get());
        const auto measure = [&](ErrorReport report, auto measure_report) {
            if (!config_.wants(report)) return;
            const ReportProgress told = scene_part(report);
            const auto named = [&](float done, const std::string& what) {
                told(done, fmt::format("{}: {}", opened.session.scene, what));
            };
            measure_report(FrameReportTask{config_, opened, tree, machines, seconds_for(report, false), named, stop_},
                           result);
        };
        measure(ErrorReport::p1, measure_images);
        measure(ErrorReport::p5, measure_truncation);
        measure(ErrorReport::p6, measure_effects);
    }

    void measure_trees(const OpenedScene& opened, const KdTree& tree, SceneErrorTime& result,
                       const ReportProgress& progress) {
        const std::size_t triangles = opened.scene.triangles.size();
        const auto leave_out = [&](ErrorReport report, const std::string& why) {
            if (config_.wants(report)) result.left_out.push_back({report, why});
        };
        if (tree.nodes.size() == 1) {
            for (const ErrorReport report : {ErrorReport::p3, ErrorReport::p4})
                leave_out(report, "the tree is one leaf, so there is nothing to predict and nothing to build");
            return;
        }
        const bool builds = triangles >= least_triangles;
        if (!builds)
            leave_out(ErrorReport::p4, fmt::format("{} triangles; up to {} any builder takes no time worth saving",
                                                   triangles, least_triangles - 1));
        if (!config_.wants(ErrorReport::p3) && !builds) return;
        TreeTask task{.scene = opened.scene, .build = opened.session.build, .trace = opened.session.trace};
        task.threads = opened.session.threads;
        task.seed = opened.session.seed;
        const double seconds = seconds_for(ErrorReport::p3, false) + seconds_for(ErrorReport::p4, false);
        task.build_seconds = builds && config_.wants(ErrorReport::p4) ? 0.4 * seconds : 0;
        task.frame_seconds = 0.4 * seconds;
        if (config_.quick) {
            task.width = task.height = 64;
            task.lines = 20000;
        }
        const auto told = [&](float done, const std::string& what) {
            progress(done, fmt::format("{}: {}", opened.session.scene, what));
        };
        result.trees = report_trees(task, told, stop_);
        check();
        note_rays(opened, result, leave_out);
    }

    template <class LeaveOut>
    static void note_rays(const OpenedScene& opened, const SceneErrorTime& result, const LeaveOut& leave_out) {
        const SceneNeeds needs = scene_needs(opened.scene, KdTree{}, opened.session.trace);
        const RayCounts& rays = result.trees->rays;
        if (!needs.reflections)
            leave_out(ErrorReport::p3, "reflection rays: no surface is reflective");
        else if (rays[std::size_t(Pass::rt_refl)] == 0)
            leave_out(ErrorReport::p3, "reflection rays: the camera sees no reflective surface");
        if (rays[std::size_t(Pass::shade_prim)] == 0) leave_out(ErrorReport::p3, "shadow rays: none is traced");
    }

    HitReport measure_hits() {
        HitTask task;
        task.rays = config_.quick ? 1000 : 20000;
        // The oracle takes about as long as the rounds.
        task.seconds_per_family = 0.6 * seconds_for(ErrorReport::p2, true) / double(hit_families().size());
        task.threads = scenes_.front().session.threads;
        task.seed = scenes_.front().session.seed;
        HitReport report = report_hits(task, part(share_of(ErrorReport::p2) / all_shares_), stop_);
        check();
        return report;
    }

    const ErrorTimeConfig& config_;
    const std::vector<OpenedScene>& scenes_;
    const ReportProgress& progress_;
    const std::stop_token& stop_;
    ErrorTimeResults results_;
    double all_shares_ = 0, done_ = 0;
};

}  // namespace

ErrorTimeResults run_error_time(const ErrorTimeConfig& config, const std::vector<OpenedScene>& scenes,
                                const ReportProgress& progress, const std::stop_token& stop) {
    return Run(config, scenes, progress, stop).measure();
}

}  // namespace kd
