#include "app/error_time/error_time_run.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "app/choices.h"
#include "app/cli/command.h"
#include "app/frame/counted_frame.h"
#include "app/frame/frame_tracer.h"
#include "app/frame/open_or_note.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/measure/double_path.h"
#include "renderer/scene/needs.h"

namespace kd {

namespace {

constexpr int probe_side = 64;
constexpr std::size_t least_triangles = 65;  // below it no tree is worth building

using Progress = std::function<void(float, const std::string&)>;

/// The share of the time that a report gets when all are made.
double share_of(ErrorReport report) {
    switch (report) {
        case ErrorReport::p1: return 0.6;
        case ErrorReport::p2: return 0.2;
        default: return 0.1;
    }
}

/// The machines of one scene, and what they are.
struct Machines {
    std::vector<std::pair<TracerKind, std::unique_ptr<FrameTracer>>> all;

    Machines(const ErrorTimeConfig& config, const OpenedScene& opened, const KdTree& tree, SceneErrorTime& result) {
        const AskedFor asked{config.gl_demanded, config.gl_demanded};
        for (const TracerKind kind : config.tracers)
            open_or_note(
                asked, [&] { add(kind, config, opened, tree); },
                [&](const std::string& why) {
                    result.left_out.push_back({ErrorReport::p1, fmt::format("{}: {}", name_of(kind), why)});
                });
    }

  private:
    void add(TracerKind kind, const ErrorTimeConfig& config, const OpenedScene& opened, const KdTree& tree) {
        const GlChoices gl{.context = config.context, .early_z = opened.session.early_z};
        all.emplace_back(kind, make_frame_tracer(kind, opened.scene, tree, opened.session.threads, gl));
    }
};

/// What the rows name themselves; how large images are, scenes.csv tells.
constexpr std::initializer_list<const char*> varied{"scene", "width", "height", "tracer", "traversal"};

class Run {
  public:
    Run(const ErrorTimeConfig& config, const std::vector<OpenedScene>& scenes, const Progress& progress,
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
    Progress part(double share) {
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
        const double share = 1 / double(scenes_.size()) / all_shares_;
        double trees = 0;
        for (const ErrorReport report : {ErrorReport::p3, ErrorReport::p4})
            if (config_.wants(report)) trees += share_of(report);
        const bool images = config_.wants(ErrorReport::p1);
        if (!images && trees == 0) return result;
        const KdTree tree =
            build_tree(opened.scene.triangles, opened.session.build, nullptr, {}, stop_, opened.session.threads);
        check();
        if (images) measure_images(opened, tree, result, part(share * share_of(ErrorReport::p1)));
        if (trees > 0) measure_trees(opened, tree, result, part(share * trees));
        return result;
    }

    void measure_images(const OpenedScene& opened, const KdTree& tree, SceneErrorTime& result,
                        const Progress& progress) {
        progress(0, fmt::format("{}: a first look", opened.session.scene));
        if (opened.scene.triangles.empty()) {
            result.left_out.push_back({ErrorReport::p1, "the scene has no triangles, so every sample is the same"});
            return;
        }
        Machines machines(config_, opened, tree, result);
        const TriangleBoxes boxes(opened.scene.triangles);
        ImageTask task{opened.scene,        boxes, opened.session.trace, {}, {}, opened.session.threads,
                       opened.session.seed, 0};
        const double seconds = seconds_for(ErrorReport::p1, false);
        task.frame_seconds = 0.1 * seconds;
        auto side = std::make_shared<int>(probe_side);
        for (auto& [kind, tracer] : machines.all)
            for (const Traversal traversal : config_.traversals) add_method(kind, *tracer, traversal, side, task);
        task.plan = plan_images(0.85 * seconds, probe(task), probe_reference(task), probe_side * probe_side);
        *side = task.plan.width;
        note_given_up(machines, task, result.notes);
        for (auto& [kind, tracer] : machines.all) {
            for (ImageMethod& method : task.methods)
                if (method.machine == name_of(kind)) method.clock = tracer->clock();
            if (!runs_on_cpu(kind)) note_gl(*tracer);
        }
        check();
        const auto told = [&](float done, const std::string& what) {
            progress(done, fmt::format("{}: {}", opened.session.scene, what));
        };
        result.images = report_images(task, told, stop_);
        check();
    }

    void add_method(TracerKind kind, FrameTracer& tracer, Traversal traversal, const std::shared_ptr<int>& side,
                    ImageTask& task) const {
        TraceConfig config = task.config;
        config.traversal = traversal;
        config.counters = false;
        tracer.prepare(config, *side, *side);
        task.methods.push_back({std::string(name_of(kind)), std::string(info(traversal).name), "",
                                [&tracer, config, side, this](const PinholeCamera& camera, Image<Vec4>& colour) {
                                    const FrameTime time = tracer.trace(config, camera, *side, *side, stop_);
                                    colour = tracer.frame(config).colour;
                                    return time.sample();
                                }});
    }

    /// The frames of a report have no counters, so a first one of each method has.
    void note_given_up(Machines& machines, const ImageTask& task, std::vector<std::string>& notes) const {
        const int width = task.plan.width, height = task.plan.height;
        TraceConfig config = task.config;
        for (auto& [kind, tracer] : machines.all)
            for (const Traversal traversal : config_.traversals) {
                config.traversal = traversal;
                const auto frame =
                    trace_counted(*tracer, config, pinhole(task.scene.camera, width, height), width, height, stop_);
                check();
                note_unfinished(frame.value(), fmt::format("{} on {}", info(traversal).name, name_of(kind)), notes);
            }
    }

    /// Its clock is known once it has traced.
    void note_gl(const FrameTracer& tracer) { results_.on = measured_on(scenes_.front().session, varied, &tracer); }

    /// Wall clock of a small frame by each method, all that it takes; the second of two.
    [[nodiscard]] std::vector<double> probe(ImageTask& task) const {
        std::vector<double> times;
        const PinholeCamera camera = pinhole(task.scene.camera, probe_side, probe_side);
        Image<Vec4> colour;
        for (ImageMethod& method : task.methods) {
            double ms = 0;
            for (int i = 0; i < 2; ++i) ms = wall_ms([&] { method.trace(camera, colour); });
            times.push_back(ms);
            check();
        }
        return times;
    }

    [[nodiscard]] double probe_reference(const ImageTask& task) const {
        return wall_ms([&] {
            (void)double_frame(task.scene, pinhole(task.scene.camera, probe_side, probe_side), probe_side, probe_side,
                               path_config(task.scene, task.config), task.threads, stop_, &task.boxes);
        });
    }

    void measure_trees(const OpenedScene& opened, const KdTree& tree, SceneErrorTime& result,
                       const Progress& progress) {
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
    const Progress& progress_;
    const std::stop_token& stop_;
    ErrorTimeResults results_;
    double all_shares_ = 0, done_ = 0;
};

}  // namespace

ErrorTimeResults run_error_time(const ErrorTimeConfig& config, const std::vector<OpenedScene>& scenes,
                                const Progress& progress, const std::stop_token& stop) {
    return Run(config, scenes, progress, stop).measure();
}

}  // namespace kd
