#include "app/report/bench_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"

namespace kd {

namespace {

/// Four digits or so, whatever the size.
std::string ms_text(double ms) { return fmt::format("{:.{}f}", ms, ms >= 1000 ? 0 : ms >= 100 ? 1 : 2); }

Json passes_json(const TimedRounds& timed) {
    Json passes = Json::object();
    for (std::size_t p = 0; p < pass_count; ++p)
        if (const TimeSummary time = timed.pass(p); time.samples > 0)
            passes[std::string(pass_names[p])] = json_of(time);
    return passes;
}

/// "upload 3.1 ms, compile 410.2 ms; RTPrim 12.00, ShadePrim 8.31 ms".
std::string parts_text(const BenchRow& row) {
    std::string passes;
    for (std::size_t p = 0; p < pass_count; ++p)
        if (const TimeSummary time = row.timed.pass(p); time.samples > 0)
            passes += fmt::format("{} {} {:.2f}", passes.empty() ? ";" : ",", pass_names[p], time.median_ms);
    if (!passes.empty()) passes += " ms";
    std::string text =
        fmt::format("upload {:.1f} ms, compile {:.1f} ms{}", row.setup.upload_ms, row.setup.compile_ms, passes);
    return text + clock_check_text(row.timed.clock_discrepancy());
}

void print_head(std::ostream& out, const BenchScene& bench) {
    const Session& s = bench.session;
    out << fmt::format("{}: {}, {} tree built in {:.1f} ms, {}x{}\n{} rays: {} primary, {} shadow, {} reflection, "
                       "{} reflection shadow\n",
                       s.scene, counted(bench.scene.triangles.size(), "triangle"), s.build.builder,
                       1e3 * bench.build.seconds, s.width, s.height, bench.ray_sum(), bench.rays[0], bench.rays[1],
                       bench.rays[2], bench.rays[3]);
}

TextTable table_of(const BenchScene& bench) {
    using enum TextTable::Align;
    TextTable table({{"tracer", left},
                     {"traversal", left},
                     {"nodes"},
                     {"ms"},
                     {"p25"},
                     {"p75"},
                     {"Mray/s"},
                     {"steps"},
                     {"tests"},
                     {"of the first", left}});
    const double rays = double(std::max<std::int64_t>(bench.ray_sum(), 1));
    for (const BenchRow& row : bench.rows) {
        const TimeSummary time = row.timed.total();
        table.add_row({std::string(name_of(row.tracer)), std::string(info(row.traversal).name),
                       fmt::format("{}", bytes_of(row.nodes)), ms_text(time.median_ms), ms_text(time.p25_ms),
                       ms_text(time.p75_ms), fmt::format("{:.2f}", bench.mrays_per_s(row)),
                       fmt::format("{:.1f}", double(row.counters.interior_first + row.counters.interior_again) / rays),
                       fmt::format("{:.1f}", double(row.counters.triangle_tests) / rays),
                       &row == &bench.rows.front() ? "" : ratio_text(bench.of_first(row))});
    }
    return table;
}

/// A line for each tracer: what it is, and what its times were read from.
std::string tracers_text(const BenchScene& bench) {
    std::string text;
    for (auto row = bench.rows.begin(); row != bench.rows.end(); ++row) {
        const bool told =
            std::any_of(bench.rows.begin(), row, [&](const BenchRow& before) { return before.tracer == row->tracer; });
        if (!told)
            text += fmt::format("{}: {}{}; clock: {}\n", name_of(row->tracer), row->renderer,
                                row->software_gl ? " (software, not a GPU)" : "", row->clock);
    }
    return text;
}

}  // namespace

double BenchScene::mrays_per_s(const BenchRow& row) const {
    const double ms = row.timed.total().median_ms;
    return ms > 0 ? double(ray_sum()) * 1e-3 / ms : 0.0;
}

MedianInterval BenchScene::of_first(const BenchRow& row) const {
    return ratio_interval(row.timed.ms(), rows.front().timed.ms());
}

Json bench_json(const BenchScene& bench, const BenchRow& row) {
    Json counters = json_of(row.counters);
    counters.erase("rays");
    const TimeSummary time = row.timed.total();
    return {{"scene", bench.session.scene},
            {"tracer", name_of(row.tracer)},
            {"ray_type", "frame"},
            {"packet", row.tracer == TracerKind::cpu_packet ? Json(bench.session.trace.packet_size) : Json(nullptr)},
            {"instructions", runs_on_cpu(row.tracer) ? Json(bench.on.instructions) : Json(nullptr)},
            {"traversal", info(row.traversal).name},
            {"nodes", bytes_of(row.nodes)},
            {"builder", bench.session.build.builder},
            {"leaf_block", bench.session.build.leaf_block},
            {"width", bench.session.width},
            {"height", bench.session.height},
            {"rays", bench.ray_sum()},
            {"ms_median", time.median_ms},
            {"ms_p25", time.p25_ms},
            {"ms_p75", time.p75_ms},
            {"rounds", time.samples},
            {"of_first", json_of(bench.of_first(row))},
            {"passes", passes_json(row.timed)},
            {"mrays_per_s", bench.mrays_per_s(row)},
            {"clock", row.clock},
            {"clock_discrepancy", row.timed.clock_discrepancy()},
            {"renderer", row.renderer},
            {"build_ms", 1e3 * bench.build.seconds},
            {"upload_ms", or_null(row.setup.upload_ms)},
            {"compile_ms", or_null(row.setup.compile_ms)},
            {"tables_ms", or_null(row.setup.tables_ms)},
            {"counters", counters},
            {"measured_on", json_of(bench.on)}};
}

void print(std::ostream& out, const BenchScene& bench, int warmup) {
    print_head(out, bench);
    table_of(bench).print(out, terminal_width());
    out << tracers_text(bench);
    for (const BenchRow& row : bench.rows)
        if (row.setup.compile_ms >= 0)
            out << fmt::format("{} {}: {}\n", name_of(row.tracer), info(row.traversal).name, parts_text(row));
    for (const std::string& note : bench.notes) out << "note: " << note << '\n';
    const std::size_t rounds = bench.rows.empty() ? 0 : bench.rows.front().timed.rounds.size();
    out << fmt::format(
        "Whole frames; {} in turn after {} warm-up; compiling, uploading and counting apart.\nms: median; p25 to p75: "
        "their middle half; steps at nodes and triangle tests per ray;\n{}.\n",
        counted(rounds, "round"), warmup,
        rounds < MedianInterval::least_samples
            ? fmt::format("too few rounds: the 95 % interval of a ratio takes {}", MedianInterval::least_samples)
            : "in brackets: the 95 % interval of the median ratio, round by round");
}

}  // namespace kd
