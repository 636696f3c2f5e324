// stats: tables about a scene's kd-tree and what rays do in it, one of several at a time.

#include <CLI/CLI.hpp>
#include <algorithm>
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

/// The one asked for by an option of its own; InputError where there are two.
Table table_of(const StatsOptions& options) {
    struct Wish {
        const char* option;
        bool asked;
        Table table;
    };
    const Wish wishes[] = {{"--bonus", options.bonuses, Table::bonus},
                           {"--traversals", options.every_traversal, Table::traversals},
                           {"--predicted", options.predicted, Table::predicted},
                           {"--divergence", options.divergence.divergence, Table::divergence},
                           {"--ballot", options.divergence.ballot, Table::ballot}};
    const Wish* chosen = nullptr;
    for (const Wish& wish : wishes) {
        if (!wish.asked) continue;
        if (chosen)
            throw InputError(
                fmt::format("{}: cannot be given with {}; ask for one of them", wish.option, chosen->option));
        chosen = &wish;
    }
    return chosen ? chosen->table : Table::trees;
}

/// What a table does not read, and what only some do.
void check_uses(const CLI::App& app, Table table, bool every_builder) {
    const auto one_of = [&](std::initializer_list<Table> tables) { return std::ranges::count(tables, table) > 0; };
    const bool walks = one_of({Table::traversals, Table::predicted, Table::divergence, Table::ballot});
    const std::string no_walks =
        "this table is about all rays; add --divergence, --ballot, --traversals or --predicted";
    const std::string several = "shows several; leave one of them out";
    refuse_idle(
        app, {{"--builders", one_of({Table::trees, Table::predicted}), "this table is about one tree; leave one out"},
              {"--builder", !every_builder, "--builders " + several},
              {"--empty-bonus", table != Table::bonus, "--bonus " + several},
              {"--rays", walks, no_walks},
              {"--csv", walks, no_walks},
              {"--svg", one_of({Table::divergence, Table::predicted}),
               "only --divergence and --predicted have charts to draw; add one of them"},
              {"--maps", table == Table::ballot, "only --ballot measures them; add it"},
              {"--tile", table == Table::divergence, "only --divergence has groups to choose; add it"}});
    for (const char* walk : {"--traversal", "--short-stack", "--plain-ropes", "--eye-leaf", "--entry-tile"})
        refuse_idle(app, {{walk, table != Table::traversals, "--traversals " + several}});
}

int run(const CLI::App& app, const StatsOptions& options, CommandContext& context) {
    const Table table = table_of(options);
    check_uses(app, table, options.every_builder);
    switch (table) {
        case Table::bonus: return run_bonuses(options, options.json, context);
        case Table::traversals: return run_traversals(options, options.divergence, options.json, context);
        case Table::predicted:
            return run_predicted(options, options.divergence, options.every_builder, options.json, context);
        case Table::divergence: return run_divergence(options, options.divergence, options.json, context);
        case Table::ballot: return run_ballots(options, options.divergence, options.json, context);
        case Table::trees: break;
    }
    note_idle(app, {bins_use(options.session_for(""), options.every_builder)}, context);
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
    hide_options(app, {"--tracer", "--early-z"});
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
