#include "app/paper/paper_tables.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/kdtree/tree.h"
#include "viz/csv.h"

namespace kd {

namespace {

std::string ms_text(double ms) { return ms < 0 ? "" : fmt::format("{:.2f}", ms); }

std::string tracer_of(const PaperNodeSizes& sizes) {
    return std::string(name_of(sizes.gpu ? TracerKind::gl_fragment : TracerKind::cpu));
}

Json rounds_json(const TimedRounds& timed) {
    Json rounds = Json::array();
    for (const TimeSample& sample : timed.rounds) {
        Json passes = Json::array();
        for (const double ms : sample.pass_ms) passes.push_back(ms < 0 ? Json(nullptr) : Json(ms));
        rounds.push_back({{"ms", sample.ms},
                          {"wall_ms", sample.wall_ms < 0 ? Json(nullptr) : Json(sample.wall_ms)},
                          {"pass_ms", passes}});
    }
    return rounds;
}

Json times_json(const PaperTimes& times) {
    return {{"method", info(times.method).name},
            {"clock", times.clock},
            {"clock_discrepancy", times.timed.clock_discrepancy()},
            {"upload_ms", times.upload_ms},
            {"compile_ms", times.compile_ms},
            {"total", json_of(times.timed.total())},
            {"rounds", rounds_json(times.timed)}};
}

Json scene_json(const PaperScene& scene) {
    Json counts = Json::array(), times = Json::array();
    for (const PaperCounts& c : scene.counts)
        counts.push_back(
            {{"traversal", info(c.traversal).name}, {"all", json_of(c.all)}, {"step_efficiency", c.step_efficiency}});
    for (const PaperTimes& t : scene.times) times.push_back(times_json(t));
    return {{"scene", scene.name},     {"triangles", scene.triangles},
            {"nodes", scene.nodes},    {"build_ms", scene.build_ms},
            {"rays", scene.ray_sum()}, {"seed_node_ratios", scene.seed_node_ratios},
            {"counts", counts},        {"times", times}};
}

}  // namespace

PaperTable verdict_table(const std::vector<PaperClaim>& claims) {
    PaperTable table{"verdicts",
                     "The paper's claims",
                     {"claim", "where", "the paper says", "our number", "value (95 % interval)", "accepted", "verdict",
                      "because", "median", "low", "high", "confidence", "samples"},
                     {}};
    for (const PaperClaim& c : claims) {
        const bool measured = c.value.samples > 0;
        const auto number = [measured](double value) { return measured ? fmt::format("{}", value) : std::string(); };
        table.rows.push_back({c.id, c.where, c.claim, c.measure, interval_text(c.value),
                              c.measure == "–" ? "–" : c.accepted.text(), std::string(name_of(c.verdict)), c.reason,
                              number(c.value.median), number(c.value.low), number(c.value.high),
                              number(c.value.confidence), fmt::format("{}", c.value.samples)});
    }
    return table;
}

PaperTable time_table(const PaperResults& results) {
    PaperTable table{"times",
                     "Times of whole frames",
                     {"scene", "method", "ms median", "p25", "p75", "rounds", "of CPURT (95 % interval)", "frames/s",
                      "Mrays/s", "RTPrim ms", "ShadePrim ms", "RTRefl ms", "ShadeRefl ms", "upload ms", "compile ms",
                      "clock", "other clock"},
                     {}};
    for (const PaperScene& scene : results.scenes)
        for (const PaperTimes& times : scene.times) {
            const TimeSummary time = times.timed.total();
            if (time.samples == 0) continue;
            std::vector<std::string> row{
                scene.name,
                std::string(info(times.method).name),
                ms_text(time.median_ms),
                ms_text(time.p25_ms),
                ms_text(time.p75_ms),
                fmt::format("{}", time.samples),
                times.method == PaperMethod::cpurt
                    ? ""
                    : ratio_text(ratio_interval(times.timed.ms(), scene.ms(PaperMethod::cpurt))),
                fmt::format("{:.2f}", 1e3 / time.median_ms),
                fmt::format("{:.2f}", 1e-3 * double(scene.ray_sum()) / time.median_ms)};
            for (std::size_t p = 0; p < pass_count; ++p) {
                const TimeSummary pass = times.timed.pass(p);
                row.push_back(pass.samples > 0 ? ms_text(pass.median_ms) : "");
            }
            row.push_back(ms_text(times.upload_ms));
            row.push_back(ms_text(times.compile_ms));
            row.push_back(times.clock);
            const double off = times.timed.clock_discrepancy();
            row.push_back(off == 0 ? "" : fmt::format("steady clock: {:+.1f} %", 100 * off));
            table.rows.push_back(std::move(row));
        }
    return table;
}

PaperTable count_table(const PaperResults& results) {
    PaperTable table{"counts",
                     "Work, counted: the same on every machine",
                     {"scene", "triangles", "nodes of the tree", "bytes a node", "build ms", "rays", "traversal",
                      "interior/ray", "of stack", "leaves/ray", "tests/ray", "restarts/ray", "step efficiency 8x4",
                      "of stack over other seeds (95 % interval)"},
                     {}};
    for (const PaperScene& scene : results.scenes)
        for (const PaperCounts& c : scene.counts) {
            const double rays = double(std::max<std::int64_t>(scene.ray_sum(), 1));
            const bool restart = c.traversal == Traversal::restart && !scene.seed_node_ratios.empty();
            table.rows.push_back({scene.name, fmt::format("{}", scene.triangles), fmt::format("{}", scene.nodes),
                                  fmt::format("{}", sizeof(TreeNode)), fmt::format("{:.1f}", scene.build_ms),
                                  fmt::format("{}", scene.ray_sum()), std::string(info(c.traversal).name),
                                  fmt::format("{:.2f}", double(c.interior()) / rays),
                                  fmt::format("{:.2f}", scene.node_ratio(c.traversal)),
                                  fmt::format("{:.2f}", double(c.all.leaves) / rays),
                                  fmt::format("{:.2f}", double(c.all.triangle_tests) / rays),
                                  fmt::format("{:.2f}", double(c.all.restarts) / rays),
                                  fmt::format("{:.3f}", c.step_efficiency),
                                  restart ? interval_text(median_interval(scene.seed_node_ratios)) : ""});
        }
    return table;
}

PaperTable budget_table(const PaperResults& results) {
    PaperTable table{"loop-budgets",
                     "Kd-restart under a ceiling of steps",
                     {"scene", "triangles", "steps allowed", "pixels unfinished", "of", "share"},
                     {}};
    for (const PaperBudget& row : results.budgets)
        table.rows.push_back({row.scene, fmt::format("{}", row.triangles), fmt::format("{}", row.budget),
                              fmt::format("{}", row.unfinished), fmt::format("{}", row.pixels),
                              fmt::format("{:.3f} %", 100 * double(row.unfinished) / double(row.pixels))});
    return table;
}

PaperTable node_size_table(const PaperResults& results) {
    PaperTable table{"node-sizes",
                     "Frames by the stack over nodes of 16 and of 8 bytes",
                     {"scene", "tracer", "nodes", "kB of 16 bytes", "kB of 8 bytes", "ms, 16 bytes", "ms, 8 bytes",
                      "16 over 8 (95 % interval)", "rounds", "clock"},
                     {}};
    for (const PaperNodeSizes& s : results.node_sizes) {
        const auto kilobytes = [&](NodeEncoding nodes) {
            return fmt::format("{:.1f}", 1e-3 * double(s.nodes) * bytes_of(nodes));
        };
        table.rows.push_back(
            {s.scene, tracer_of(s), fmt::format("{}", s.nodes), kilobytes(NodeEncoding::float4),
             kilobytes(NodeEncoding::packed), ms_text(s.wide.total().median_ms), ms_text(s.packed.total().median_ms),
             ratio_text(ratio_interval(s.wide.ms(), s.packed.ms())), fmt::format("{}", s.wide.rounds.size()), s.clock});
    }
    return table;
}

PaperTable run_table(const PaperResults& results, const std::vector<PaperClaim>& claims) {
    PaperTable table{"run", "How this was measured", {"what", "value"}, {}};
    for (const auto& [name, value] : results.on.facts()) table.rows.push_back({name, value});
    table.rows.push_back({"picture", fmt::format("{} x {} pixels", results.width, results.height)});
    table.rows.push_back({"rounds", fmt::format("{} of all tracers in turn", results.rounds)});
    for (const PaperVerdict verdict : measured_verdicts)
        table.rows.push_back({std::string(name_of(verdict)),
                              fmt::format("{}", std::ranges::count(claims, verdict, &PaperClaim::verdict))});
    for (const std::string& note : results.notes) table.rows.push_back({"note", note});
    return table;
}

std::string table_csv(const PaperTable& table, const std::vector<std::string>& comments) {
    std::string text = csv_comments(comments) + csv_comment(table.title) + csv_line(table.header);
    for (const std::vector<std::string>& row : table.rows) text += csv_line(row);
    return text;
}

Json paper_json(const PaperResults& results, const std::vector<PaperClaim>& claims) {
    Json verdicts = Json::array(), scenes = Json::array(), budgets = Json::array(), sizes = Json::array(),
         tests = Json::array();
    for (const PaperClaim& c : claims)
        verdicts.push_back({{"claim", c.id},
                            {"value", json_of(c.value)},
                            {"accepted", c.accepted.text()},
                            {"verdict", name_of(c.verdict)},
                            {"because", c.reason}});
    for (const PaperScene& scene : results.scenes) scenes.push_back(scene_json(scene));
    for (const PaperBudget& row : results.budgets)
        budgets.push_back(
            {{"scene", row.scene}, {"budget", row.budget}, {"pixels", row.pixels}, {"unfinished", row.unfinished}});
    for (const PaperNodeSizes& s : results.node_sizes)
        sizes.push_back({{"scene", s.scene},
                         {"tracer", tracer_of(s)},
                         {"clock", s.clock},
                         {"nodes", s.nodes},
                         {"ms_16_bytes", json_of(s.wide.total())},
                         {"ms_8_bytes", json_of(s.packed.total())},
                         {"16_over_8_bytes", json_of(ratio_interval(s.wide.ms(), s.packed.ms()))},
                         {"rounds_16_bytes", rounds_json(s.wide)},
                         {"rounds_8_bytes", rounds_json(s.packed)}});
    for (const PaperTriangleTests& t : results.triangle_tests)
        tests.push_back({{"scene", t.scene},
                         {"ms_once", json_of(t.once.total())},
                         {"ms_twice", json_of(t.twice.total())},
                         {"rounds_once", rounds_json(t.once)},
                         {"rounds_twice", rounds_json(t.twice)}});
    return {{"measured_on", json_of(results.on)},
            {"complete", results.complete},
            {"width", results.width},
            {"height", results.height},
            {"rounds", results.rounds},
            {"verdicts", verdicts},
            {"scenes", scenes},
            {"budgets", budgets},
            {"node_sizes", sizes},
            {"triangle_tests", tests},
            {"notes", results.notes}};
}

}  // namespace kd
