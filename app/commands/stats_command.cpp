// stats: tables about a scene's kd-tree and what rays do in it, one of several at a time.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>

#include "app/cli/idle_options.h"
#include "app/commands/commands.h"
#include "app/commands/stats_bonus.h"
#include "app/commands/stats_divergence.h"
#include "app/commands/stats_predicted.h"
#include "app/commands/stats_traversals.h"
#include "app/commands/stats_trees.h"
#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

struct StatsOptions : CommonOptions {
    bool every_builder = false;
    bool every_traversal = false;
    bool bonuses = false;
    bool predicted = false;
    bool json = false;
    DivergenceOptions divergence;
};

enum class Table { trees, bonus, traversals, predicted, divergence, ballot };

/// That asks for the table; empty where none is needed.
constexpr std::array<std::string_view, 6> table_options{
    "", "--bonus", "--traversals", "--predicted", "--divergence", "--ballot"};
std::string_view option_of(Table table) { return table_options[std::size_t(table)]; }

/// The one asked for by an option of its own; InputError where there are two.
Table table_of(const StatsOptions& options) {
    const std::pair<Table, bool> wishes[] = {{Table::bonus, options.bonuses},
                                             {Table::traversals, options.every_traversal},
                                             {Table::predicted, options.predicted},
                                             {Table::divergence, options.divergence.divergence},
                                             {Table::ballot, options.divergence.ballot}};
    Table chosen = Table::trees;
    for (const auto& [table, asked] : wishes) {
        if (!asked) continue;
        if (chosen != Table::trees)
            throw InputError(
                fmt::format("{}: cannot be given with {}; ask for one of them", option_of(table), option_of(chosen)));
        chosen = table;
    }
    return chosen;
}

/// "--bonus writes no charts; leave it out, or take --divergence instead": for an option that `table` has no use for.
std::string not_of(Table table, std::string_view what, std::string_view tables_that_do) {
    if (table == Table::trees) return fmt::format("the table of trees {}; add {}", what, tables_that_do);
    return fmt::format("{} {}; leave one out, or take {} instead", option_of(table), what, tables_that_do);
}

/// What a table does not read, and what only some do.
void check_uses(const CLI::App& app, Table table, bool every_builder) {
    const auto one_of = [&](std::initializer_list<Table> tables) { return std::ranges::count(tables, table) > 0; };
    const bool walks = one_of({Table::traversals, Table::predicted, Table::divergence, Table::ballot});
    const std::string_view walking = "--divergence, --ballot, --traversals or --predicted";
    const std::string several = "shows several; leave one of them out";
    refuse_idle(app,
                {{"--builders", one_of({Table::trees, Table::predicted}),
                  fmt::format("{} is about one tree; leave one of them out", option_of(table))},
                 {"--builder", !every_builder, "--builders " + several},
                 {"--empty-bonus", table != Table::bonus, "--bonus " + several},
                 {"--rays", walks, not_of(table, "is about all rays together", walking)},
                 {"--csv", walks, not_of(table, "is written by --json, not as CSV", walking)},
                 {"--svg", one_of({Table::divergence, Table::predicted}),
                  not_of(table, "has no charts", "--divergence or --predicted")},
                 {"--maps", table == Table::ballot, not_of(table, "has no maps", "--ballot")},
                 {"--tile", table == Table::divergence, not_of(table, "has no groups to choose", "--divergence")}});
    for (const char* walk : {"--traversal", "--short-stack", "--plain-ropes", "--eye-leaf", "--entry-tile"})
        refuse_idle(app, {{walk, table != Table::traversals, "--traversals " + several}});
}

/// What only a part of the scenes or walks would read.
void note_uses(const CLI::App& app, Table table, const StatsOptions& options, const CommandContext& context) {
    const auto one_of = [&](std::initializer_list<Table> tables) { return std::ranges::count(tables, table) > 0; };
    const bool every_walk =
        table == Table::traversals || (one_of({Table::divergence, Table::ballot}) && !options.traversal);
    const bool lines = table == Table::predicted;
    const auto seeded = [&](const std::string& scene) { return seed_use(scene, lines).acts; };
    std::vector<OptionUse> uses = walk_uses(options.session_for(""), every_walk);
    uses.push_back(bins_use(options.session_for(""), options.every_builder));
    uses.push_back({"--context", one_of({Table::trees, Table::ballot}), "this table is made on the CPU alone"});
    if (std::ranges::none_of(options.scenes, seeded)) uses.push_back(seed_use(options.scenes.front(), lines));
    note_idle(app, uses, context);
}

int run(const CLI::App& app, const StatsOptions& options, CommandContext& context) {
    const Table table = table_of(options);
    check_uses(app, table, options.every_builder);
    note_uses(app, table, options, context);
    switch (table) {
        case Table::bonus: return run_bonuses(options, options.json, context);
        case Table::traversals: return run_traversals(options, options.divergence, options.json, context);
        case Table::predicted:
            return run_predicted(options, options.divergence, options.every_builder, options.json, context);
        case Table::divergence: return run_divergence(options, options.divergence, options.json, context);
        case Table::ballot: return run_ballots(options, options.divergence, options.json, context);
        case Table::trees: break;
    }
    return run_trees(options, options.every_builder, options.json, context);
}

CommandBody declare(CLI::App& app) {
    const auto options = std::make_shared<StatsOptions>();
    add_scenes(app, *options);
    app.add_flag("--builders", options->every_builder, "All builders side by side");
    app.add_flag("--json", options->json, "JSON instead of a table");
    app.add_flag("--bonus", options->bonuses,
                 "Instead: trees with bonuses for empty space from 0 to 0.8, with the gate and without, timed in turn");
    app.add_flag("--traversals", options->every_traversal, "Instead: what every traversal visits, side by side");
    app.add_flag("--predicted", options->predicted,
                 "Instead: visits of nodes, counted and as the surface area heuristic predicts them");
    add_divergence_options(app, options->divergence);
    add_frame_options(app, *options);
    add_camera_options(app, *options);
    hide_options(app, {"--tracer", "--packet", "--early-z"});
    return [options, &app](CommandContext& context) { return run(app, *options, context); };
}

}  // namespace

Command stats_command() {
    return {"stats", "Tables about a scene's kd-tree and about groups of rays in it",
            "Examples:\n"
            "  kdscope stats ball:9000 rooms\n"
            "  kdscope stats scatter:10000 --builders --json\n"
            "  kdscope stats ball:9000 --divergence --traversal restart --rays primary --svg width.svg\n"
            "  kdscope stats ball:9000 --ballot --size 128x128\n"
            "  kdscope stats ball:9000 rooms --bonus\n"
            "  kdscope stats ball:9000 rooms scatter:10000 --traversals --rays primary\n"
            "  kdscope stats rooms --predicted --rays primary --svg predicted.svg\n",
            declare};
}

}  // namespace kd
