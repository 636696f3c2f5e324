#include "app/commands/stats_traversals.h"

#include <fmt/format.h>
#include <ostream>

#include "app/cli/counted.h"
#include "app/cli/output_file.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/walk_table.h"
#include "renderer/scene/camera.h"
#include "viz/csv.h"

namespace kd {

namespace {

struct Table {
    std::string scene;
    Pass rays;
    const std::vector<WalkRow>& rows;

    [[nodiscard]] const CounterTotals& totals(const WalkRow& row) const { return row.totals[std::size_t(rays)]; }
    [[nodiscard]] double of_stack(const WalkRow& row) const { return row.of(rows.front(), rays); }
    /// All of it is about primary rays.
    [[nodiscard]] std::string published(const WalkRow& row) const {
        return rays == Pass::rt_prim ? row.variant.published : std::string();
    }
};

void print(std::ostream& out, const Table& table, const FlatScene& scene, const Session& session) {
    out << fmt::format("{}: {}; {}x{}, {} rays\n", table.scene, contents_text(scene), session.width, session.height,
                       ray_names[std::size_t(table.rays)]);
    if (table.rows.empty() || table.totals(table.rows.front()).rays == 0) {
        out << "no pixel has one\n";
        return;
    }
    using enum TextTable::Align;
    TextTable text({{"per ray", left},
                    {"interior"},
                    {"again"},
                    {"leaves"},
                    {"tests"},
                    {"ways back"},
                    {"of stack"},
                    {"published", left, /*may_drop=*/true}});
    for (const WalkRow& row : table.rows) {
        const CounterTotals& t = table.totals(row);
        const auto number = [&](std::uint64_t sum) { return fmt::format("{:.2f}", double(sum) / double(t.rays)); };
        text.add_row({row.variant.name, number(row.interior(table.rays)), number(t.interior_again), number(t.leaves),
                      number(t.triangle_tests), number(t.restarts + t.backtracks),
                      fmt::format("{:.2f}", table.of_stack(row)), table.published(row)});
    }
    text.print(out, terminal_width());
}

Json json_of(const Table& table) {
    Json rows = Json::array();
    for (const WalkRow& row : table.rows)
        rows.push_back({{"name", row.variant.name},
                        {"traversal", info(row.variant.config.traversal).name},
                        {"short_stack", row.variant.config.short_stack},
                        {"optimised_ropes", row.variant.config.optimised_ropes},
                        {"eye_leaf", row.variant.config.eye_leaf},
                        {"entry_tile", row.variant.config.entry_tile},
                        {"of_stack", table.of_stack(row)},
                        {"published", table.published(row)},
                        {"counters", kd::json_of(table.totals(row))}});
    return {{"scene", table.scene}, {"rays", json_key(ray_names[std::size_t(table.rays)])}, {"walks", rows}};
}

std::string csv_of(const Table& table) {
    std::string csv;
    for (const WalkRow& row : table.rows) {
        const CounterTotals& t = table.totals(row);
        csv += csv_row(table.scene, ray_names[std::size_t(table.rays)], row.variant.name, t.rays, t.interior_first,
                       t.interior_again, t.leaves, t.triangle_tests, t.restarts, t.backtracks, table.of_stack(row));
    }
    return csv;
}

constexpr const char* csv_head =
    "scene,rays,walk,ray_count,interior_first,interior_again,leaves,triangle_tests,restarts,backtracks,of_stack\n";

constexpr const char* explanation =
    "\ninterior: visits of interior nodes; again: of nodes that the ray had been at. ways back: restarts\n"
    "and climbs; of ropes, rays that kd-restart took over. of stack: interior visits over the stack's.\n"
    "published (below its row where lines are too short): the same ratio by Popov et al. 2007, Table 2,\n"
    "down steps of primary rays in four scenes; Horn et al. 2007; the paper, section 4.3.\n";

}  // namespace

int run_traversals(const CommonOptions& common, const DivergenceOptions& options, bool json, CommandContext& context) {
    check_outputs({{"--csv", options.csv}}, {});
    const MeasuredOn on = measured_on(common.session, {"scene", "tracer", "traversal"});
    std::string csv = csv_comments(on.lines()) + csv_head;
    Json all = Json::array();
    for (const std::string& name : common.scenes) {
        const auto [session, scene, tree, camera] = open_walked(common, name, context);
        const std::vector<WalkRow> rows = walk_table({.scene = scene,
                                                      .tree = tree,
                                                      .config = session.trace,
                                                      .camera = camera,
                                                      .width = session.width,
                                                      .height = session.height,
                                                      .threads = session.threads},
                                                     context.stop);
        check_stop(context);
        for (const Pass rays : rays_of(scene, session.trace, options)) {
            const Table table{name, rays, rows};
            if (!json) print(context.out, table, scene, session);
            csv += csv_of(table);
            all.push_back(with_machine(json_of(table), on));
        }
    }
    context.out << (json ? json_text(all) : explanation);
    write_files(options, csv, {}, context);
    return exit_ok;
}

}  // namespace kd
