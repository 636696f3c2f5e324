#include "renderer/measure/error_time/hit_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "renderer/geometry/order_statistics.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/error_time/ranking.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/sweep.h"
#include "renderer/measure/stability/sweep_judge.h"
#include "renderer/trace/upper_bound.h"

namespace kd {

namespace {

struct Stopped {};

std::vector<HitMethod> all_methods() {
    std::vector<HitMethod> all;
    for (const TriangleTest test : {TriangleTest::woop, TriangleTest::moeller_trumbore})
        for (const bool in_double : {false, true})
            for (const Rules rules : {Rules::robust, Rules::as_published})
                for (const TraversalInfo& traversal : traversals())
                    if (traversal.has_published_form()) all.push_back({test, in_double, rules, traversal.id});
    return all;
}

/// One family's scene and rays, with all that answers are held against.
class Stage {
  public:
    Stage(const HitFamily& family, const HitTask& task, const std::stop_token& stop)
        : Stage(make(family, task), task, stop) {}

    [[nodiscard]] std::span<const Ray> rays() const { return rays_; }
    [[nodiscard]] const WalkScene& scene() const { return *walk_scene_; }

    [[nodiscard]] HitRow judge(const HitMethod& method, const std::vector<HitAnswer>& answers) const {
        HitRow row;
        row.method = method;
        std::vector<double> ulps;
        const std::vector<HitAnswer>& own_loop = loop(method.test, method.in_double);
        const std::vector<HitAnswer>& best_loop = loop(TriangleTest::woop, method.in_double);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const HitAnswer& found = answers[i];
            SweepFault fault = judge_->judge(i, found.triangle, found.t);
            // The loop over all triangles must not know better: with the watertight test whether there is a hit, with
            // the method's own where.
            if (found.triangle < 0 && best_loop[i].triangle >= 0) fault.missed = true;
            if (found.triangle >= 0 && found.t != own_loop[i].t) fault.wrong = true;
            ++row.n;
            row.missed += fault.missed;
            row.wrong += fault.wrong && !fault.missed;
            if (fault.ulps >= 0) ulps.push_back(fault.ulps);
        }
        row.upper95 = upper_bound_95(row.missed + row.wrong, row.n);
        summarise_ulps(ulps, row);
        return row;
    }

  private:
    static SweepScene make(const HitFamily& family, const HitTask& task) {
        const Sweep& sweep = sweep_of(std::string(family.id));
        Random random = sweep_random(sweep, task.seed);
        return sweep.make(family.value, task.rays, random);
    }

    Stage(SweepScene made, const HitTask& task, const std::stop_token& stop)
        : scene_(flat_scene(made)), rays_(std::move(made.rays)), tree_(build_tree(scene_.triangles, made.build)),
          walk_scene_(std::make_unique<WalkScene>(scene_, tree_)),
          judge_(std::make_unique<SweepJudge>(scene_, rays_, made.every_ray_hits, task.threads, stop)) {
        for (const TriangleTest test : {TriangleTest::woop, TriangleTest::moeller_trumbore})
            for (const bool in_double : {false, true}) {
                if (stop.stop_requested()) throw Stopped{};
                std::vector<HitAnswer>& answers = loops_[std::size_t(test)][in_double];
                answers.resize(rays_.size());
                walk_rays(*walk_scene_, {test, in_double, Rules::robust, Traversal::naive}, rays_, answers);
            }
    }

    [[nodiscard]] const std::vector<HitAnswer>& loop(TriangleTest test, bool in_double) const {
        return loops_[std::size_t(test)][in_double];
    }

    static void summarise_ulps(std::vector<double>& ulps, HitRow& row) {
        if (ulps.empty()) return;
        row.ulp_p50 = percentile(ulps, 0.5);
        row.ulp_p999 = percentile(ulps, 0.999);
        row.ulp_most = std::ranges::max(ulps);
    }

    FlatScene scene_;
    std::vector<Ray> rays_;
    KdTree tree_;
    std::unique_ptr<WalkScene> walk_scene_;
    std::unique_ptr<SweepJudge> judge_;
    std::vector<HitAnswer> loops_[2][2];  // over all triangles, by test and precision
};

/// The rows of one family: judged once, which warms up, then timed in turn.
std::vector<HitRow> measure(const HitFamily& family, const HitTask& task, const std::function<void(float)>& progress,
                            const std::stop_token& stop) {
    const Stage stage(family, task, stop);
    std::vector<HitAnswer> answers(stage.rays().size());
    std::vector<HitRow> rows;
    std::vector<Contestant> contestants;
    const std::vector<HitMethod> methods = all_methods();
    for (const HitMethod& method : methods) {
        if (stop.stop_requested()) throw Stopped{};
        walk_rays(stage.scene(), method, stage.rays(), answers);
        rows.push_back(stage.judge(method, answers));
        rows.back().family = family.id;
        contestants.push_back({method.family_name(), [&, method] {
                                   if (stop.stop_requested()) throw Stopped{};
                                   return TimeSample{
                                       wall_ms([&] { walk_rays(stage.scene(), method, stage.rays(), answers); })};
                               }});
    }
    const TimingPlan plan = rounds_within(task.seconds_per_family, 0);
    const auto round_done = [&](int rounds, const auto&) { progress(float(rounds) / float(plan.rounds)); };
    const auto times = time_in_turn(contestants, plan, round_done);
    const double ns = 1e6 / double(std::max<std::size_t>(stage.rays().size(), 1));
    std::vector<TimeAndError> all;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const TimeSummary time = times[i].total();
        rows[i].ns = ns * time.median_ms;
        rows[i].quartiles = {ns * time.p25_ms, ns * time.p75_ms};
        rows[i].rounds = time.samples;
        rows[i].of_first = ratio_interval(times[i].ms(), times.front().ms());
        all.push_back({rows[i].ns, rows[i].per_million()});
    }
    const std::vector<bool> front = pareto_front(all);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].on_front = front[i];
    return rows;
}

}  // namespace

std::span<const HitFamily> hit_families() {
    // T18: its own centre (148376, 1234, -223423) lies 134,103 radii off.
    static constexpr HitFamily families[] = {
        {"T14", 40, "random rays inside a closed sphere: benign"},
        {"T15", 1e-9, "rays at edges of a closed sphere"},
        {"T16", 1e-9, "rays at vertices of a closed sphere"},
        {"T10", 1e-8, "rays along axes inside the planes of a voxel city"},
        {"T18", 134103, "random rays inside a closed sphere far from the origin"},
        {"T25", 1e-5, "rays at slivers a hundred thousand times as long as wide"},
    };
    return families;
}

HitReport report_hits(const HitTask& task, const std::function<void(float, const std::string&)>& progress,
                      std::stop_token stop) {
    HitReport report;
    report.rays = task.rays;
    const std::span<const HitFamily> families = hit_families();
    try {
        for (std::size_t i = 0; i < families.size(); ++i) {
            const auto told = [&](float done) {
                if (progress)
                    progress((float(i) + done) / float(families.size()),
                             fmt::format("{}: {}", families[i].id, families[i].what));
            };
            told(0);
            for (HitRow& row : measure(families[i], task, told, stop)) report.rows.push_back(std::move(row));
        }
        report.complete = true;
    } catch (const Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
