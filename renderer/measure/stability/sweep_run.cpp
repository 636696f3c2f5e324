#include "renderer/measure/stability/sweep_run.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "renderer/geometry/input_error.h"
#include "renderer/geometry/order_statistics.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/measure/stability/sweep_judge.h"
#include "renderer/measure/timing.h"
#include "renderer/trace/given_up.h"
#include "renderer/trace/upper_bound.h"

namespace kd {

namespace {

/// Adds up what a method answered at one value.
class Tally {
  public:
    explicit Tally(SweepRow& row) : row_(row) {}

    void add(const SweepFault& fault) {
        ++row_.n;
        row_.missed += fault.missed;
        row_.wrong += fault.wrong;
        if (fault.ulps >= 0) ulps_.push_back(fault.ulps);
    }

    void add_given_up() {
        ++row_.n;
        ++row_.given_up;
    }

    void finish() {
        row_.upper95 = upper_bound_95(row_.missed + row_.wrong, row_.answered());
        if (ulps_.empty()) return;
        row_.worst_ulp = std::ranges::max(ulps_);
        row_.p99_ulp = percentile(ulps_, 0.99);
    }

  private:
    SweepRow& row_;
    std::vector<double> ulps_;
};

/// The scene of one value, with what its rays are held against.
struct Stage {
    FlatScene scene;
    std::vector<Ray> rays;
    KdTree tree;
    std::vector<Hit> loop;  // by all triangles in single precision

    Stage(SweepScene made, int threads, const std::stop_token& stop)
        : scene(flat_scene(made)), rays(std::move(made.rays)),
          tree(build_tree(scene.triangles, made.build, nullptr, {}, stop, threads)),
          loop(brute_force(scene, rays, threads, stop)) {}
};

class SweepRun {
  public:
    struct Stopped {};

    SweepRun(const SweepConfig& config, SweepReport& report, std::stop_token stop)
        : config_(config), report_(report), stop_(std::move(stop)) {
        machines_ = open_machines(config, "measured", report.notes);
    }

    void measure(double value, SweepScene made) {
        const bool every_ray_hits = made.every_ray_hits;
        const Stage stage(std::move(made), config_.threads, stop_);
        check_stop();
        SweepRow exact = row(value, {"double", "-", "-", "naive"});
        std::unique_ptr<SweepJudge> judge;
        exact.seconds =
            1e-3 * wall_ms([&] {
                judge = std::make_unique<SweepJudge>(stage.scene, stage.rays, every_ray_hits, config_.threads, stop_);
            });
        check_stop();
        for (const auto& machine : machines_) {
            machine->load(stage.scene, stage.tree);
            for (const TraceConfig& trace : ways(*machine)) trace_all(value, stage, *judge, *machine, trace);
        }
        Tally tally(exact);
        for (std::size_t i = 0; i < stage.rays.size(); ++i)
            tally.add(judge->judge(i, judge->in_double()[i].triangle, judge->in_double()[i].t));
        tally.finish();
        report_.rows.push_back(exact);
    }

  private:
    static SweepRow row(double value, SweepMethod method) {
        SweepRow made;
        made.value = value;
        made.method = std::move(method);
        return made;
    }

    void check_stop() const {
        if (stop_.stop_requested()) throw Stopped{};
    }

    /// Robust and as published; on the CPU, where it is cheap, the first edition's rules as well.
    [[nodiscard]] std::vector<TraceConfig> ways(const RayMachine& machine) const {
        std::vector<TraceConfig> all;
        for (const RulesInfo& rules : all_rules())
            for (const TraversalInfo& traversal : traversals()) {
                const auto& wanted = config_.traversals;
                const bool chosen = wanted.empty() ? traversal.id == Traversal::stack
                                                   : std::ranges::find(wanted, traversal.name) != wanted.end();
                const bool robust = rules.id == Rules::robust;
                if (!chosen || (!robust && !traversal.has_published_form())) continue;
                if (rules.id == Rules::first_edition && !machine.on_cpu()) continue;
                TraceConfig trace;
                trace.rules = rules.id;
                trace.traversal = traversal.id;
                if (machine.has_walk(trace)) all.push_back(trace);
            }
        return all;
    }

    void trace_all(double value, const Stage& stage, const SweepJudge& judge, RayMachine& machine,
                   const TraceConfig& trace) {
        SweepRow measured = row(value, {machine.tracer(), machine.context(), std::string(info(trace.rules).name),
                                        std::string(info(trace.traversal).name)});
        std::vector<Hit> hits(stage.rays.size());
        std::vector<RayCounters> counters(stage.rays.size());
        measured.seconds =
            1e-3 * wall_ms([&] { (void)machine.trace(trace, stage.rays, false, hits, counters, stop_); });
        check_stop();
        Tally tally(measured);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (was_given_up(counters[i].exit_reason)) {
                tally.add_given_up();
                continue;
            }
            SweepFault fault = judge.judge(i, hits[i].triangle, double(hits[i].t));
            const Hit& loop = stage.loop[i];
            // Whatever the exact answer: the loop over all triangles with the same triangle test must not know better.
            if (hits[i].triangle < 0 && loop.triangle >= 0) fault.missed = true;
            if (hits[i].triangle >= 0 && hits[i].t != loop.t) fault.wrong = true;
            tally.add(fault);
        }
        tally.finish();
        report_.rows.push_back(measured);
    }

    const SweepConfig& config_;
    SweepReport& report_;
    std::stop_token stop_;
    std::vector<std::unique_ptr<RayMachine>> machines_;
};

}  // namespace

std::string SweepMethod::name() const {
    if (tracer == "double") return tracer;
    return fmt::format("{}, {}{}", rules, tracer == "gl-fragment" ? "gl" : tracer,
                       traversal == "stack" ? "" : ", " + traversal);
}

std::vector<SweepMethod> SweepReport::methods() const {
    std::vector<SweepMethod> all;
    for (const SweepRow& row : rows)
        if (std::ranges::find(all, row.method) == all.end()) all.push_back(row.method);
    return all;
}

SweepReport run_sweep(const SweepConfig& config,
                      const std::function<void(float, const std::string&, const SweepReport&)>& progress,
                      std::stop_token stop) {
    const Sweep& sweep = sweep_of(config.id);
    const auto info = std::ranges::find(stability_cases(), sweep.id, &StabilityCase::id);
    SweepReport report;
    report.id = sweep.id;
    report.title = info->title;
    report.parameter = sweep.parameter;
    report.unit = sweep.unit;
    report.logarithmic = sweep.logarithmic;
    report.values = sweep.values;
    try {
        SweepRun run(config, report, stop);
        for (std::size_t i = 0; i < sweep.values.size(); ++i) {
            const std::string what = fmt::format("{} at {:g} {}", sweep.parameter, sweep.values[i], sweep.unit);
            if (progress) progress(float(i) / float(sweep.values.size()), what, report);
            Random random = sweep_random(sweep, config.seed);
            run.measure(sweep.values[i], sweep.make(sweep.values[i], config.rays, random));
        }
        report.complete = true;
    } catch (const SweepRun::Stopped&) {
        report.complete = false;
    }
    return report;
}

}  // namespace kd
