#include "app/report/dynamic_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/tracer_choices.h"
#include "renderer/cpu/threads.h"
#include "renderer/measure/motion/tree_maker.h"

namespace kd {

namespace {

using enum TextTable::Align;

int counted_threads(int threads) { return threads > 0 ? threads : default_threads(); }

TimeSummary step_time(const MotionRow& row, FrameStep step) { return summarise(row.stats.step_ms[std::size_t(step)]); }

std::string name_of(FrameSchedule schedule) { return std::string(frame_schedule_names[std::size_t(schedule)]); }

std::string share_text(double share) { return fmt::format("{:.0f} %", 100 * share); }

double median_of(const std::vector<double>& values) { return summarise(values).median_ms; }

TextTable times_table(const MotionBench& result) {
    TextTable table({{"schedule", left},
                     {"rebuild", left},
                     {"ms"},
                     {"p25"},
                     {"p75"},
                     {"update"},
                     {"build"},
                     {"upload"},
                     {"trace"},
                     {"of serial", left}});
    for (const MotionRow& row : result.rows) {
        const TimeSummary frame = summarise(row.stats.frame_ms);
        std::vector<std::string> cells{name_of(row.schedule), row.way, short_number(frame.median_ms),
                                       short_number(frame.p25_ms), short_number(frame.p75_ms)};
        for (const std::vector<double>& step : row.stats.step_ms) cells.push_back(short_number(median_of(step)));
        const MedianInterval ratio = result.of_serial(row);
        cells.push_back(ratio.samples > 0 ? ratio_text(ratio) : "");
        table.add_row(std::move(cells));
    }
    return table;
}

TextTable sides_table(const MotionBench& result) {
    TextTable table(
        {{"schedule", left}, {"rebuild", left}, {"latency ms"}, {"builder idle"}, {"tracer idle"}, {"both at work"}});
    for (const MotionRow& row : result.rows)
        table.add_row({name_of(row.schedule), row.way, short_number(median_of(row.stats.latency_ms)),
                       share_text(row.stats.builder_idle), share_text(row.stats.tracer_idle),
                       share_text(row.stats.overlap)});
    return table;
}

/// "3.2 times the rays"; why there is no such number otherwise.
std::string even_text(const BreakEven& even) {
    if (even.times_rays) return fmt::format("at {} times the rays", short_number(*even.times_rays));
    return even.saved_build_ms <= 0 ? "never: it saves nothing" : "always: it traces no slower";
}

/// The first schedule's row of each way.
TextTable ways_table(const DynamicBench& bench) {
    TextTable table({{"rebuild", left},
                     {"SAH cost"},
                     {"loss"},
                     {"worst"},
                     {"build saved ms"},
                     {"trace lost ms"},
                     {"breaks even", left}});
    for (const WayQuality& quality : bench.result.qualities) {
        const MotionRow* row = bench.result.find(bench.plan.schedules.front(), quality.way);
        const std::optional<BreakEven> even = row ? break_even(bench.result, *row) : std::nullopt;
        const double worst = *std::ranges::max_element(quality.loss);
        table.add_row({quality.way, short_number(median_of(quality.sah_cost)),
                       fmt::format("{:.1f} %", 100 * median_of(quality.loss)), fmt::format("{:.1f} %", 100 * worst),
                       even ? decimals_text(even->saved_build_ms, 2) : "",
                       even ? decimals_text(even->lost_trace_ms, 2) : "", even ? even_text(*even) : ""});
    }
    return table;
}

std::string mib_text(const std::optional<std::int64_t>& bytes) {
    return bytes ? fmt::format("{:.1f} MiB", double(*bytes) / (1 << 20)) : "not known";
}

std::string head_text(const DynamicBench& bench) {
    const Session& s = bench.session;
    return fmt::format("{}: {}, {:.3g} s of motion, {}x{}, {} by {} ({} to build, {} to trace)", s.scene,
                       counted(bench.triangles, "triangle"), bench.duration, s.width, s.height,
                       info(s.trace.traversal).name, tracer_text(s.tracer, s.trace),
                       counted(counted_threads(bench.plan.build_threads), "thread"),
                       runs_on_cpu(s.tracer)          ? counted(counted_threads(s.threads), "thread")
                       : !bench.on.gl_threads.empty() ? bench.on.gl_threads + " threads"
                                                      : "a GPU");
}

Json quality_json(const WayQuality& quality) {
    return {{"seconds", quality.seconds},
            {"sah_cost", quality.sah_cost},
            {"sah_loss", quality.loss},
            {"sah_cost_median", median_of(quality.sah_cost)},
            {"sah_loss_median", median_of(quality.loss)},
            {"refit_refused", quality.refused},
            {"why_refused", quality.why_refused.empty() ? Json(nullptr) : Json(quality.why_refused)}};
}

Json even_json(const std::optional<BreakEven>& even) {
    if (!even) return nullptr;
    return {{"saved_build_ms", even->saved_build_ms},
            {"lost_trace_ms", even->lost_trace_ms},
            {"times_rays", even->times_rays ? Json(*even->times_rays) : Json(nullptr)}};
}

Json bytes_json(const std::optional<std::int64_t>& bytes) { return bytes ? Json(*bytes) : Json(nullptr); }

Json row_json(const DynamicBench& bench, const MotionRow& row) {
    const TimeSummary frame = summarise(row.stats.frame_ms);
    const bool cpu = runs_on_cpu(bench.session.tracer);
    Json steps = Json::object();
    for (std::size_t step = 0; step < frame_step_names.size(); ++step)
        steps[std::string(frame_step_names[step])] = json_of(step_time(row, FrameStep(step)));
    const WayQuality* quality = bench.result.quality(row.way);
    return {{"scene", bench.session.scene},
            {"triangles", bench.triangles},
            {"schedule", name_of(row.schedule)},
            {"rebuild", row.way},
            {"builder", row.way == refit_way ? bench.plan.build.builder : row.way},
            {"tracer", name_of(bench.session.tracer)},
            {"traversal", info(bench.session.trace.traversal).name},
            {"build_threads", counted_threads(bench.plan.build_threads)},
            {"trace_threads", cpu ? Json(counted_threads(bench.session.threads)) : Json(nullptr)},
            {"width", bench.session.width},
            {"height", bench.session.height},
            {"first_s", bench.plan.first_seconds},
            {"step_s", bench.plan.step_seconds},
            {"duration_s", bench.duration},
            {"frames", frame.samples},
            {"rounds", row.round_ms.size()},
            {"ms_median", frame.median_ms},
            {"ms_p25", frame.p25_ms},
            {"ms_p75", frame.p75_ms},
            {"steps", steps},
            {"latency", json_of(summarise(row.stats.latency_ms))},
            {"builder_idle", row.stats.builder_idle},
            {"tracer_idle", row.stats.tracer_idle},
            {"overlap", row.stats.overlap},
            {"of_serial", json_of(bench.result.of_serial(row))},
            {"quality", quality ? quality_json(*quality) : Json(nullptr)},
            {"break_even", even_json(break_even(bench.result, row))},
            {"memory_begin", bytes_json(bench.result.memory_begin)},
            {"memory_end", bytes_json(bench.result.memory_end)},
            {"memory_peak", bytes_json(bench.result.memory_peak)},
            {"first_frame_repeats", bench.result.first_frame_repeats},
            {"renderer", bench.renderer},
            {"measured_on", json_of(bench.on)}};
}

}  // namespace

Json dynamic_json(const DynamicBench& bench) {
    Json rows = Json::array();
    for (const MotionRow& row : bench.result.rows) rows.push_back(row_json(bench, row));
    return rows;
}

std::string gantt_caption(const DynamicBench& bench) {
    return head_text(bench) + fmt::format("; {}", bench.on.cpu) +
           (runs_on_cpu(bench.session.tracer) ? "" : ", " + bench.renderer);
}

void print(std::ostream& out, const DynamicBench& bench) {
    const MotionBench& result = bench.result;
    out << head_text(bench) << '\n' << bench.renderer << (bench.software_gl ? " (software, not a GPU)" : "") << "\n\n";
    const std::size_t width = terminal_width();
    times_table(result).print(out, width);
    out << '\n';
    sides_table(result).print(out, width);
    out << '\n';
    ways_table(bench).print(out, width);
    out << fmt::format(
        "\n{} of each row in {}, each after {} warm-up; rows in turn.\n"
        "ms: from the end of one picture to the end of the next, median; p25 to p75: their middle half;\n"
        "update to trace: medians of the steps; of serial: the median ratio of rounds with its 95 % interval;\n"
        "latency: from the moment whose scene it shows to the finished picture; loss: SAH cost over that of a\n"
        "tree that {} makes anew at the same time, median and worst of {};\n"
        "saved and lost: against {}, {} schedule; breaks even: so many times the rays a\n"
        "frame make slower tracing cost what building saves.\n",
        counted(bench.plan.frames, "frame"), counted(bench.plan.rounds, "round"), bench.plan.warmup,
        bench.plan.build.builder, counted(bench.plan.quality_samples, "time"), bench.plan.ways.front(),
        name_of(bench.plan.schedules.front()));
    for (const WayQuality& quality : result.qualities)
        if (quality.refused > 0)
            out << fmt::format("note: {}: {} built anew: {}\n", quality.way, counted(quality.refused, "tree"),
                               quality.why_refused);
    out << fmt::format("memory: {} after the first round, {} after the last, {} at most\n",
                       mib_text(result.memory_begin), mib_text(result.memory_end), mib_text(result.memory_peak));
    out << (result.first_frame_repeats ? "frame 0 repeats to the bit after all others\n"
                                       : "FAILED: frame 0 is not the same after all others\n");
}

}  // namespace kd
