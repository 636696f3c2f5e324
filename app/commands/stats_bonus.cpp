#include "app/commands/stats_bonus.h"

#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"

namespace kd {

namespace {

/// One tree of the scene, with what its picture took.
struct Row {
    BuildConfig build;
    KdTree tree;
    TreeStats stats;
    CounterTotals visits;  // of all rays of the picture
    std::unique_ptr<CpuTracer> tracer;
    TimedRounds timed;
};

/// None, and each of the others with the session's gate and with none, the paper's rule.
std::vector<Row> rows_of(const BuildConfig& start) {
    std::vector<Row> rows;
    const auto add = [&](float bonus, float gate) {
        BuildConfig build = start;
        build.empty_bonus = bonus;
        build.empty_bonus_gate = gate;
        rows.push_back({build, {}, {}, {}, {}, {}});
    };
    add(0, start.empty_bonus_gate);
    for (const float bonus : {0.2f, 0.4f, 0.8f}) {
        if (start.empty_bonus_gate > 0) add(bonus, start.empty_bonus_gate);
        add(bonus, 0);
    }
    return rows;
}

void measure(std::vector<Row>& rows, const Session& s, const FlatScene& scene, CommandContext& context) {
    const PinholeCamera camera = pinhole(scene.camera, s.width, s.height);
    ProgressLine progress(context);
    TraceConfig config = s.trace;
    config.counters = false;
    std::vector<Contestant> contestants;
    const auto frame = std::make_shared<Frame>(s.width, s.height);
    for (Row& row : rows) {
        const std::string name = fmt::format("bonus {} from {}", row.build.empty_bonus, row.build.empty_bonus_gate);
        const auto show = [&](float done) { progress.show(done, s.scene + ": " + name); };
        row.tree = build_tree(scene.triangles, row.build, nullptr, show, context.stop, s.threads);
        check_stop(context);
        row.stats = tree_stats(row.tree, scene.triangles.size(), row.build);
        row.tracer = std::make_unique<CpuTracer>(scene, row.tree);
        row.tracer->trace_frame(s.trace, camera, *frame, s.threads, context.stop);
        check_stop(context);
        row.visits = sum_of(pass_totals(*frame));
        contestants.push_back({name, [&row, &s, &context, &progress, camera, config, frame, name] {
                                   progress.show(0, s.scene + ": timing " + name);
                                   const double ms = wall_ms([&] {
                                       row.tracer->trace_frame(config, camera, *frame, s.threads, context.stop);
                                   });
                                   check_stop(context);
                                   return TimeSample{ms};
                               }});
    }
    const std::vector<TimedRounds> times = time_in_turn(contestants, {.warmup = 2, .rounds = 31});
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].timed = times[i];
}

struct PerRay {
    double interior, leaves, tests;
};

PerRay per_ray(const CounterTotals& t) {
    const double rays = double(std::max<std::uint64_t>(t.rays, 1));
    return {double(t.interior_first + t.interior_again) / rays, double(t.leaves) / rays,
            double(t.triangle_tests) / rays};
}

MedianInterval of_none(const Row& row, const std::vector<Row>& rows) {
    return ratio_interval(row.timed.ms(), rows.front().timed.ms());
}

void print(std::ostream& out, const std::vector<Row>& rows, const Session& s, const FlatScene& scene) {
    out << fmt::format("{}: {}\n{} tree, {}x{}, all rays of the picture by {} on the CPU\n", s.scene,
                       contents_text(scene), s.build.builder, s.width, s.height, info(s.trace.traversal).name);
    using enum TextTable::Align;
    TextTable table({{"bonus"},
                     {"gate"},
                     {"nodes"},
                     {"SAH cost"},
                     {"interior"},
                     {"leaves"},
                     {"tests"},
                     {"ms"},
                     {"time of none", left}});
    for (const Row& row : rows) {
        const PerRay ray = per_ray(row.visits);
        const TimeSummary time = row.timed.total();
        table.add_row({fmt::format("{}", row.build.empty_bonus),
                       row.build.empty_bonus > 0 ? fmt::format("{}", row.build.empty_bonus_gate) : "-",
                       fmt::format("{}", row.stats.nodes), fmt::format("{:.2f}", row.stats.sah_cost),
                       fmt::format("{:.2f}", ray.interior), fmt::format("{:.2f}", ray.leaves),
                       fmt::format("{:.2f}", ray.tests), fmt::format("{:.2f}", time.median_ms),
                       &row == &rows.front() ? "1" : ratio_text(of_none(row, rows))});
    }
    table.print(out, terminal_width());
    out << fmt::format(
        "interior, leaves, tests: visits and triangle tests per ray. ms: median of {} rounds in turn, "
        "after a\nwarm-up; time of none: over that without a bonus, round by round, with its 95 % interval.\n",
        rows.front().timed.rounds.size());
}

Json json_of(const Row& row, const std::vector<Row>& rows) {
    const PerRay ray = per_ray(row.visits);
    const TimeSummary time = row.timed.total();
    return {{"empty_bonus", json_number(row.build.empty_bonus)},
            {"empty_bonus_gate", json_number(row.build.empty_bonus_gate)},
            {"tree", kd::json_of(row.stats)},
            {"interior_per_ray", ray.interior},
            {"leaves_per_ray", ray.leaves},
            {"tests_per_ray", ray.tests},
            {"time", kd::json_of(time)},
            {"time_of_none", kd::json_of(of_none(row, rows))}};
}

}  // namespace

int run_bonuses(const CommonOptions& options, bool as_json, CommandContext& context) {
    Json json = Json::array();
    for (const std::string& name : options.scenes) {
        Session session = options.session_for(name);
        check_frame_memory(session.width, session.height);
        const FlatScene scene = open_scene(options, session, context);
        std::vector<Row> rows = rows_of(session.build);
        measure(rows, session, scene, context);
        if (!as_json) {
            if (name != options.scenes.front()) context.out << '\n';
            print(context.out, rows, session, scene);
            context.out.flush();
            continue;
        }
        Json trees = Json::array();
        for (const Row& row : rows) trees.push_back(json_of(row, rows));
        json.push_back(
            scene_report(session, scene, "bonuses", std::move(trees), measured_on(session.threads, session.seed)));
    }
    if (as_json) context.out << json_text(json);
    return exit_ok;
}

}  // namespace kd
