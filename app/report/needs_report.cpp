#include "app/report/needs_report.h"

#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "viz/numbers.h"

namespace kd {

namespace {

std::vector<FeatureTime> time_left_out(const Rendering& r, const GlChoices& gl, int rounds, CommandContext& context,
                                       NeedsReport& report) {
    const Session& s = r.session;
    const std::vector<Feature> features = timed_features(r.facts, s.trace, runs_on_cpu(s.tracer));
    const auto tracer = make_frame_tracer(s.tracer, r.scene, r.tree, s.threads, gl);
    const PinholeCamera camera = pinhole(r.scene.camera, s.width, s.height);
    TraceConfig config = s.trace;
    config.counters = false;
    const auto frame = [&](FeatureSet forced) {
        config.forced = forced;
        tracer->prepare(config, s.width, s.height);
        return tracer->trace(config, camera, s.width, s.height, context.stop).sample();
    };
    ProgressLine progress(context);
    (void)frame({});
    const auto show = [&](float done) {
        progress.show(done, "timing what is left out");
        return !context.stop.stop_requested();
    };
    std::vector<FeatureTime> times = time_features(features, frame, rounds, show);
    check_stop(context);
    report.renderer = tracer->renderer();
    if (tracer->software_gl()) report.renderer += " (software, not a GPU)";
    report.clock = tracer->clock();
    if (!times.empty()) report.clock += clock_check_text(times.front().clock_discrepancy);
    return times;
}

std::string ms_text(double ms) { return fmt::format("{:.2f}", ms); }

}  // namespace

std::string_view NeedRow::state() const {
    if (gpu_only) return "GPU only";
    if (need.needed) return "needed";
    return in_use ? "put back" : "left out";
}

std::vector<NeedRow> need_rows(const FlatScene& scene, const KdTree& tree, const SceneFacts& facts,
                               const Session& session, const std::vector<FeatureTime>& times) {
    const bool on_cpu = runs_on_cpu(session.tracer);
    const auto cpu = on_cpu ? std::optional(cpu_mode(session.tracer)) : std::nullopt;
    const SceneNeeds needs = scene_needs(facts, session.trace);
    std::vector<NeedRow> rows;
    for (const FeatureInfo& feature : features()) {
        NeedRow row{&feature, feature.need(facts, session.trace), needs.*feature.in_use, on_cpu && !feature.on_cpu};
        row.bytes = feature_bytes(feature.id, scene, tree, facts, session.trace, cpu, session.width, session.height);
        for (const FeatureTime& time : times)
            if (time.feature == feature.id) row.time = time;
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string saved_text(const NeedRow& row) {
    if (!row.time) return "";
    if (!row.time->saved.sure()) return "too few rounds";
    if (!row.time->seen()) return "no difference seen";
    const MedianInterval& saved = row.time->saved;
    return fmt::format("{} ms ({} – {})", ms_text(saved.median), ms_text(saved.low), ms_text(saved.high));
}

std::string bytes_text(std::int64_t bytes) {
    if (bytes == 0) return "";
    if (bytes < 0) return "-" + bytes_text(-bytes);
    constexpr double kilo = 1000, mega = 1e6;
    if (double(bytes) < kilo) return counted(std::size_t(bytes), "byte");
    return double(bytes) < mega ? number_text(double(bytes) / kilo) + " kB" : number_text(double(bytes) / mega) + " MB";
}

NeedsReport needs_report(const Rendering& r, const GlChoices& gl, int rounds, CommandContext& context) {
    NeedsReport report;
    report.rounds = rounds;
    std::vector<FeatureTime> times;
    if (rounds > 0) times = time_left_out(r, gl, rounds, context, report);
    report.rows = need_rows(r.scene, r.tree, r.facts, r.session, times);
    return report;
}

void print(std::ostream& out, const NeedsReport& report) {
    using enum TextTable::Align;
    TextTable table({{"feature", left},
                     {"", left},
                     {"saves ms"},
                     {"from"},
                     {"to"},
                     {"share"},
                     {"memory"},
                     {"because", left, true}});
    for (const NeedRow& row : report.rows) {
        std::string saved = "-", low, high, share;
        if (row.time) {
            saved = ms_text(row.time->saved.median);
            low = row.time->saved.sure() ? ms_text(row.time->saved.low) : "-";
            high = row.time->saved.sure() ? ms_text(row.time->saved.high) : "-";
            share = row.time->seen()         ? fmt::format("{:.1f} %", 100 * row.time->share())
                    : row.time->saved.sure() ? "no difference seen"
                                             : "too few rounds";
        }
        const std::string force = row.need.can_return ? fmt::format(" (--force {})", row.feature->name) : "";
        table.add_row({std::string(row.feature->title), std::string(row.state()), saved, low, high, share,
                       bytes_text(row.bytes), row.need.why + force});
    }
    table.print(out, terminal_width());
    if (report.renderer.empty()) return;
    out << fmt::format(
        "Saved: time of a frame with the feature put back, alone, minus time without, {} in turn:\nthe median and the "
        "interval that holds it with 95 %. Frames are timed without counters.\n{}\nMemory: of tables and "
        "targets.\nClock: {}; {}.\n",
        counted(std::size_t(report.rounds), "round"),
        report.rounds < MedianInterval::least_samples
            ? fmt::format("Too few rounds: an interval takes {}.", MedianInterval::least_samples)
            : "No difference seen: the interval holds 0.",
        report.clock, report.renderer);
}

Json json_of(const NeedsReport& report) {
    Json rows = Json::array();
    for (const NeedRow& row : report.rows) {
        Json json{{"feature", row.feature->name}, {"title", row.feature->title},       {"state", row.state()},
                  {"because", row.need.why},      {"can_return", row.need.can_return}, {"bytes", row.bytes},
                  {"saved_ms", nullptr}};
        if (row.time)
            json["saved_ms"] = {{"median", row.time->saved.median},
                                {"low", row.time->saved.low},
                                {"high", row.time->saved.high},
                                {"rounds", row.time->saved.samples},
                                {"frame", row.time->without.median_ms},
                                {"seen", row.time->seen()},
                                {"clock_discrepancy", row.time->clock_discrepancy}};
        rows.push_back(std::move(json));
    }
    return rows;
}

}  // namespace kd
