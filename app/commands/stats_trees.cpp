#include "app/commands/stats_trees.h"

#include <array>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <span>

#include "app/cli/counted.h"
#include "app/cli/progress_line.h"
#include "app/cli/terminal.h"
#include "app/cli/text_table.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "app/scenes.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/ray_count.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

/// One tree of one scene.
struct Entry {
    std::string builder;
    TreeStats stats;
    BuildReport build;                             // its phases are medians of all rounds
    TimeSummary build_time;                        // of all rounds
    std::array<CounterTotals, pass_count> visits;  // of the rays that the session's picture takes, by the CPU
    std::optional<GlMemory> gl;
    std::string gl_refused;  // why there is no `gl`
};

/// A context for measuring what the tracer's textures take; stats can do without.
struct GlProbe {
    explicit GlProbe(ContextKind kind) {
        try {
            context = Context::create(kind);
            tracer = std::make_unique<GlTracer>(*context);
        } catch (const std::runtime_error& error) {
            refused = error.what();
        }
    }

    void measure(const FlatScene& scene, const KdTree& tree, const Session& session, Entry& entry) {
        entry.gl_refused = refused;
        if (!tracer) return;
        try {
            tracer->upload(scene, tree);
            tracer->prepare({.trace = session.trace}, session.width, session.height);
            entry.gl = tracer->memory();
        } catch (const std::runtime_error& error) {
            entry.gl_refused = error.what();
        }
    }

    std::unique_ptr<Context> context;
    std::unique_ptr<GlTracer> tracer;
    std::string refused;
};

std::string bytes_text(std::int64_t bytes) {
    if (bytes < 10'000) return fmt::format("{} B", bytes);
    if (bytes < 10'000'000) return fmt::format("{:.1f} kB", double(bytes) * 1e-3);
    return fmt::format("{:.1f} MB", double(bytes) * 1e-6);
}

std::int64_t total(const GlMemory& m) {
    return m.nodes + m.boxes + m.references + m.triangles + m.attributes + m.textures + m.targets;
}

struct Quantity {
    const char* title;
    std::string (*text)(const Entry&);
};

/// Shares of the leaves in percent, by triangles: the edges of these classes.
constexpr std::array<int, 6> leaf_classes{0, 1, 2, 4, 8, std::numeric_limits<int>::max()};
constexpr const char* leaf_classes_title = "leaves of 0/1/2/3-4/5-8/9+, %";

std::string leaf_shares_text(const Entry& e) {
    std::string text;
    std::size_t size = 0;
    for (const int last : leaf_classes) {
        std::int64_t leaves = 0;
        for (; size < e.stats.leaf_sizes.size() && int(size) <= last; ++size) leaves += e.stats.leaf_sizes[size];
        text += fmt::format("{}{:.0f}", text.empty() ? "" : "/", 100.0 * double(leaves) / double(e.stats.leaves));
    }
    return text;
}

std::string phases_text(const Entry& e) {
    const BuildPhases& p = e.build.phases;
    const int decimals = p.sum() < 0.01 ? 1 : 0;
    return fmt::format("{:.{}f}/{:.{}f}/{:.{}f}/{:.{}f}", 1e3 * p.prepare, decimals, 1e3 * p.choose, decimals,
                       1e3 * p.divide, decimals, 1e3 * p.leaves, decimals);
}

template <Pass rays>
std::string visits_text(const Entry& e) {
    const CounterTotals& t = e.visits[std::size_t(rays)];
    if (t.rays == 0) return "-";
    const auto mean = [&](std::uint64_t sum) { return double(sum) / double(t.rays); };
    return fmt::format("{:.1f}/{:.1f}/{:.1f}", mean(t.interior_first + t.interior_again), mean(t.leaves),
                       mean(t.triangle_tests));
}

std::string gl_text(const Entry& e, std::int64_t GlMemory::*part) { return e.gl ? bytes_text((*e.gl).*part) : "-"; }

std::string share_text(std::int64_t part, std::int64_t whole) {
    return fmt::format("{} ({:.0f} %)", part, whole > 0 ? 100.0 * double(part) / double(whole) : 0.0);
}

constexpr Quantity quantities[] = {
    {"nodes", [](const Entry& e) { return fmt::format("{}", e.stats.nodes); }},
    {"interior nodes", [](const Entry& e) { return fmt::format("{}", e.stats.interior); }},
    {"leaves", [](const Entry& e) { return fmt::format("{}", e.stats.leaves); }},
    {"empty leaves", [](const Entry& e) { return share_text(e.stats.empty_leaves, e.stats.leaves); }},
    {leaf_classes_title, leaf_shares_text},
    {"largest leaf, triangles", [](const Entry& e) { return fmt::format("{}", e.stats.largest_leaf); }},
    {"deepest leaf, levels", [](const Entry& e) { return fmt::format("{}", e.stats.deepest); }},
    {"mean leaf depth, levels", [](const Entry& e) { return fmt::format("{:.2f}", e.stats.mean_leaf_depth); }},
    {"references", [](const Entry& e) { return fmt::format("{}", e.stats.references); }},
    {"references per triangle", [](const Entry& e) { return fmt::format("{:.2f}", e.stats.references_per_triangle); }},
    {"SAH cost, traversal steps", [](const Entry& e) { return fmt::format("{:.2f}", e.stats.sah_cost); }},
    {"expected interior visits",
     [](const Entry& e) { return fmt::format("{:.2f}", e.stats.expected_interior_visits); }},
    {"expected leaf visits", [](const Entry& e) { return fmt::format("{:.2f}", e.stats.expected_leaf_visits); }},
    {"expected triangle tests", [](const Entry& e) { return fmt::format("{:.2f}", e.stats.expected_triangle_tests); }},
    {"visits: primary rays", visits_text<Pass::rt_prim>},
    {"visits: shadow rays", visits_text<Pass::shade_prim>},
    {"visits: reflection rays", visits_text<Pass::rt_refl>},
    {"visits: reflection-shadow rays", visits_text<Pass::shade_refl>},
    {"build, ms", [](const Entry& e) { return fmt::format("{:.1f}", e.build_time.median_ms); }},
    {"prepare/choose/divide/leaves, ms", phases_text},
    {"limits hit",
     [](const Entry& e) {
         const std::string depth = e.build.depth_limit_hit ? "depth" : "";
         const std::string cap = e.build.reference_cap_hit ? "references" : "";
         return depth.empty() && cap.empty() ? "none" : depth + (depth.empty() || cap.empty() ? "" : ", ") + cap;
     }},
    {"memory: nodes of 16 bytes", [](const Entry& e) { return bytes_text(e.stats.node_bytes); }},
    {"memory: nodes of 8 bytes", [](const Entry& e) { return bytes_text(e.stats.packed_node_bytes); }},
    {"memory: lists of references", [](const Entry& e) { return bytes_text(e.stats.reference_list_bytes); }},
    {"memory: lists of copies", [](const Entry& e) { return bytes_text(e.stats.duplicated_list_bytes); }},
    {"GL: nodes", [](const Entry& e) { return gl_text(e, &GlMemory::nodes); }},
    {"GL: node boxes", [](const Entry& e) { return gl_text(e, &GlMemory::boxes); }},
    {"GL: references", [](const Entry& e) { return gl_text(e, &GlMemory::references); }},
    {"GL: triangles", [](const Entry& e) { return gl_text(e, &GlMemory::triangles); }},
    {"GL: normals, uv, materials", [](const Entry& e) { return gl_text(e, &GlMemory::attributes); }},
    {"GL: images", [](const Entry& e) { return gl_text(e, &GlMemory::textures); }},
    {"GL: targets", [](const Entry& e) { return gl_text(e, &GlMemory::targets); }},
    {"GL: all", [](const Entry& e) { return e.gl ? bytes_text(total(*e.gl)) : "-"; }},
};

Json json_of(const Entry& e) {
    Json visits = Json::object();
    for (std::size_t rays = 0; rays < pass_count; ++rays) visits[option_name(Pass(rays))] = kd::json_of(e.visits[rays]);
    Json json{{"builder", e.builder},
              {"build_ms", e.build_time.median_ms},
              {"build_time", kd::json_of(e.build_time)},
              {"build_phases", kd::json_of(e.build.phases)},
              {"idle_hand_splits", e.build.idle_hand_splits},
              {"visits", visits},
              {"depth_limit_hit", e.build.depth_limit_hit},
              {"reference_cap_hit", e.build.reference_cap_hit},
              {"tree", kd::json_of(e.stats)}};
    if (e.gl)
        json["gl_bytes"] = {{"nodes", e.gl->nodes},           {"boxes", e.gl->boxes},
                            {"references", e.gl->references}, {"triangles", e.gl->triangles},
                            {"attributes", e.gl->attributes}, {"textures", e.gl->textures},
                            {"targets", e.gl->targets},       {"all", total(*e.gl)}};
    else
        json["gl_bytes"] = nullptr;
    return json;
}

std::string footer(const Session& session, const std::vector<Entry>& entries) {
    const auto rounds = std::size_t(entries.front().build_time.samples);
    return fmt::format(
        "Expected: of a uniform line that meets the bounds. Visits: interior nodes/leaves/triangle tests per\n"
        "ray, counted on the CPU in a {}x{} picture with {}.\n"
        "Build: medians of {}{} after a warm-up, by the wall clock on {};\nphases of the build are added over its "
        "threads.\n",
        session.width, session.height, info(session.trace.traversal).name, counted(rounds, "round"),
        entries.size() > 1 ? ", builders in turn," : "",
        counted(std::size_t(measured_on(session.threads, session.seed).threads), "thread"));
}

void print(std::ostream& out, const Session& session, const FlatScene& scene, const std::vector<Entry>& entries) {
    out << fmt::format("{}: {}\n", session.scene, contents_text(scene));
    for (const std::string& note : scene.notes) out << "note: " << note << '\n';
    std::vector<TextTable::Column> columns{{.title = "builder", .align = TextTable::Align::left, .repeats = true}};
    for (const Entry& entry : entries) columns.push_back({entry.builder});
    TextTable table(columns);
    for (const Quantity& quantity : quantities) {
        std::vector<std::string> cells{quantity.title};
        for (const Entry& entry : entries) cells.push_back(quantity.text(entry));
        table.add_row(cells);
    }
    table.print(out, terminal_width());
    out << footer(session, entries);
    for (const Entry& entry : entries)
        for (const std::string& note : build_notes(entry.build))
            if (note != reference_cap_note) out << fmt::format("note: {}: {}\n", entry.builder, note);
    out << fmt::format("GL: memory of gl-fragment with {}, nodes of {} bytes, {} lists and a {}x{} picture.\n",
                       info(session.trace.traversal).name, bytes_of(nodes_in_force(session.trace)),
                       name_of(session.trace.leaf_lists), session.width, session.height);
    for (const Entry& entry : entries)
        if (!entry.gl) out << fmt::format("GL memory with {} is not known: {}\n", entry.builder, entry.gl_refused);
}

/// A scene and the rays that its picture takes, the same for every tree.
struct MeasuredScene {
    Session session;
    FlatScene scene;
    PinholeCamera camera;
};

Entry measure(MeasuredScene& of, const std::string& builder, GlProbe& probe, ProgressLine& progress,
              const CommandContext& context) {
    const FlatScene& scene = of.scene;
    Session session = of.session;
    session.build.builder = builder;
    Entry entry{builder, {}, {}, {}, {}, {}, {}};
    const auto show = [&](float done) { progress.show(done, session.scene + ": " + builder); };
    const KdTree tree = build_tree(scene.triangles, session.build, &entry.build, show, context.stop, session.threads);
    check_stop(context);
    entry.stats = tree_stats(tree, scene.triangles.size(), session.build);
    Frame frame(session.width, session.height);
    CpuTracer(scene, tree).trace_frame(session.trace, of.camera, frame, session.threads, context.stop);
    check_stop(context);
    entry.visits = pass_totals(frame);
    probe.measure(scene, tree, session, entry);
    return entry;
}

/// Builds that take a second together are timed often, longer ones three times.
const TimingPlan build_rounds{.warmup = 1, .rounds = 15, .budget_s = 1, .least_rounds = 3};

/// Each phase's own median: small cells are timed by sample, which a single interruption may upset.
BuildPhases median_phases(std::span<const BuildPhases> rounds) {
    BuildPhases medians;
    for (const auto phase : {&BuildPhases::prepare, &BuildPhases::choose, &BuildPhases::divide, &BuildPhases::leaves})
        medians.*phase = summarise(rounds, [phase](const BuildPhases& p) { return p.*phase; }).median_ms;
    return medians;
}

/// Builds all the trees again, in turn.
void time_builds(const MeasuredScene& of, std::vector<Entry>& entries, ProgressLine& progress,
                 const CommandContext& context) {
    std::vector<std::vector<BuildPhases>> phases(entries.size());
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        BuildConfig config = of.session.build;
        config.builder = entries[i].builder;
        contestants.push_back({config.builder, [&, i, config] {
                                   progress.show(0, of.session.scene + ": timing " + config.builder);
                                   BuildReport report;
                                   (void)build_tree(of.scene.triangles, config, &report, {}, context.stop,
                                                    of.session.threads);
                                   check_stop(context);
                                   phases[i].push_back(report.phases);
                                   return TimeSample{1e3 * report.seconds};
                               }});
    }
    const std::vector<TimedRounds> timed = time_in_turn(contestants, build_rounds);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i].build_time = timed[i].total();
        entries[i].build.phases = median_phases(std::span(phases[i]).subspan(build_rounds.warmup));
    }
}

}  // namespace

std::vector<std::string> builders_of(const Session& session, bool every) {
    if (!every) return {session.build.builder};
    std::vector<std::string> names;
    for (const Builder& builder : builders()) names.emplace_back(builder.name);
    return names;
}

int run_trees(const CommonOptions& options, bool every_builder, bool as_json, CommandContext& context) {
    GlProbe probe(options.context.value_or(ContextKind::automatic));
    if (!probe.context && options.context) throw ContextError(probe.refused);
    ProgressLine progress(context);
    Json json = Json::array();
    for (const std::string& name : options.scenes) {
        Session session = options.session_for(name);
        FlatScene scene = open_scene(options, session, context);
        check_frame_memory(session.width, session.height);
        const PinholeCamera camera = pinhole(scene.camera, session.width, session.height);
        MeasuredScene of{session, std::move(scene), camera};
        std::vector<Entry> entries;
        for (const std::string& builder : builders_of(session, every_builder))
            entries.push_back(measure(of, builder, probe, progress, context));
        time_builds(of, entries, progress, context);
        if (!as_json) {
            if (name != options.scenes.front()) context.out << '\n';
            print(context.out, session, of.scene, entries);
            continue;
        }
        Json trees = Json::array();
        for (const Entry& entry : entries) trees.push_back(json_of(entry));
        json.push_back(
            scene_report(session, of.scene, "trees", std::move(trees), measured_on(session.threads, session.seed)));
    }
    if (as_json) context.out << json_text(json);
    return exit_ok;
}

}  // namespace kd
