#include "app/commands/verify_needs.h"

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

void print(std::ostream& out, const std::string& scene, const NeedsCheckReport& report) {
    using enum TextTable::Align;
    out << fmt::format("{}: pixels that differ when a feature is put back\n", scene);
    TextTable table({{"feature", left},
                     {"tracer", left},
                     {"context", left},
                     {"traversal", left},
                     {"pixels"},
                     {"colours"},
                     {"primary hits"},
                     {"primary counters"},
                     {"shadow"},
                     {"reflection"},
                     {"refl. shadow"},
                     {"verdict", left}});
    for (const NeedsCheckRow& row : report.rows)
        table.add_row({row.feature, row.tracer, row.context, row.traversal, fmt::format("{}", row.pixels),
                       fmt::format("{}", row.colours), fmt::format("{}", row.hits), fmt::format("{}", row.counters),
                       fmt::format("{}", row.others[1]), fmt::format("{}", row.others[2]),
                       fmt::format("{}", row.others[3]), row.good() ? "good" : "WRONG"});
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
