#include "app/commands/verify_needs.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/text_table.h"
#include "app/commands/verify_scenes.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "renderer/measure/needs_check.h"

namespace kd {

namespace {

NeedsCheckConfig config_for(const CommonOptions& options, const Session& session) {
    NeedsCheckConfig config;
    config.width = session.width;
    config.height = session.height;
    config.trace = first_sample(session);
    config.traversals = {session.trace.traversal};
    static_cast<MachineChoice&>(config) =
        wanted_machines(options, {TracerKind::cpu, TracerKind::gl_fragment, TracerKind::gl_compute});
    return config;
}

Json json_of(const std::string& scene, const NeedsCheckReport& report) {
    Json rows = Json::array();
    for (const NeedsCheckRow& row : report.rows) {
        Json others;
        for (std::size_t pass = 1; pass < pass_count; ++pass) others[json_key(ray_names[pass])] = row.others[pass];
        rows.push_back({{"feature", row.feature},
                        {"tracer", row.tracer},
                        {"context", row.context},
                        {"traversal", row.traversal},
                        {"pixels", row.pixels},
                        {"colours", row.colours},
                        {"primary_hits", row.hits},
                        {"primary_counters", row.counters},
                        {"other_rays", others}});
    }
    return {{"scene", scene}, {"passed", report.passed()}, {"rows", rows}, {"notes", report.notes}};
}

/// Passes after RTPrim in which some row found a difference.
std::vector<std::size_t> other_passes(const NeedsCheckReport& report) {
    std::vector<std::size_t> passes;
    for (std::size_t pass = 1; pass < pass_count; ++pass)
        if (std::ranges::any_of(report.rows, [&](const NeedsCheckRow& row) { return row.others[pass] > 0; }))
            passes.push_back(pass);
    return passes;
}

void print(std::ostream& out, const std::string& scene, const NeedsCheckReport& report) {
    using enum TextTable::Align;
    out << fmt::format("{}: pixels that differ when a feature is put back\n", scene);
    const std::vector<std::size_t> others = other_passes(report);
    std::vector<TextTable::Column> columns{{"feature", left},   {"tracer", left},    {"context", left},
                                           {"traversal", left}, {"pixels"},          {"colours"},
                                           {"primary hits"},    {"primary counters"}};
    for (const std::size_t pass : others) columns.push_back({std::string(ray_names[pass])});
    columns.push_back({"verdict", left});
    TextTable table(columns);
    for (const NeedsCheckRow& row : report.rows) {
        std::vector<std::string> cells{row.feature, row.tracer, row.context, row.traversal};
        for (const std::int64_t n : {row.pixels, row.colours, row.hits, row.counters})
            cells.push_back(fmt::format("{}", n));
        for (const std::size_t pass : others) cells.push_back(fmt::format("{}", row.others[pass]));
        cells.emplace_back(row.good() ? "good" : "WRONG");
        table.add_row(cells);
    }
    table.print(out);
    for (const std::string& note : report.notes) out << "note: " << note << '\n';
    out << (report.passed() ? "passed\n" : report.rows.empty() ? "failed: nothing was checked\n" : "failed\n");
}

}  // namespace

int verify_needs(const CommonOptions& options, bool as_json, CommandContext& context) {
    check_frame_memory(options.session.width, options.session.height);
    const auto check = [&](const Session& session, const FlatScene& scene, const CheckProgress& show) {
        const KdTree tree = build_tree(scene.triangles, session.build, nullptr, {}, context.stop, session.threads);
        check_stop(context);
        const NeedsCheckReport report = check_needs(scene, tree, config_for(options, session), show, context.stop);
        return CheckedScene{report.passed(), json_of(session.scene, report),
                            [report, name = session.scene](std::ostream& out) { print(out, name, report); }};
    };
    return check_scenes(options, as_json, context, check);
}

}  // namespace kd
