// The six tracers by name: which commands run them all, and what each has no use for.

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "app/choices.h"
#include "app/tracer_choices.h"
#include "renderer/gl/ray_queues.h"
#include "tests/app/cli_run.h"
#include "tests/support/refusal.h"

namespace kd {
namespace {

using json = nlohmann::json;
using test::run_kdscope;
using Words = std::vector<std::string>;

const std::set<std::string> six{"cpu", "cpu-wide", "cpu-packet", "gl-fragment", "gl-compute", "gl-wavefront"};

/// The outcome of a command that runs every tracer, OpenGL's on OSMesa; nothing where there is none.
std::optional<test::Outcome> run_all(Words arguments) {
    arguments.insert(arguments.end(), {"--context", "osmesa"});
    const test::Outcome outcome = run_kdscope(arguments);
    if (outcome.code == 3) return std::nullopt;
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
}

std::set<std::string> tracers_in(const json& rows) {
    std::set<std::string> found;
    for (const json& row : rows) found.insert(row["tracer"].get<std::string>());
    return found;
}

TEST(Tracers, EachHasItsWordsAndEveryChoiceItsUse) {
    EXPECT_EQ(choices::tracers().size(), six.size());
    for (const auto& [name, tracer] : choices::tracers()) {
        EXPECT_TRUE(six.contains(name)) << name;
        EXPECT_FALSE(summary_of(tracer).empty()) << name;
        EXPECT_EQ(runs_on_cpu(tracer), name.starts_with("cpu"));
    }
    using enum TracerChoice;
    for (const TracerChoice choice : {threads, context, early_z, count_shaded, packet, leaf_lists}) {
        const auto uses = [&](const auto& tracer) { return why_idle(choice, tracer.value).empty(); };
        const auto all = choices::tracers();
        EXPECT_TRUE(std::ranges::any_of(all, uses)) << int(choice);
        EXPECT_FALSE(std::ranges::all_of(all, uses)) << int(choice);
    }
}

TEST(Tracers, BenchTimesAllOfThem) {
    const auto outcome = run_all(
        {"bench", "cornell", "--json", "--size", "16x12", "--rounds", "1", "--warmup", "0", "--traversal", "stack"});
    if (!outcome) GTEST_SKIP() << "NO CONTEXT";
    const json rows = json::parse(outcome->out);
    EXPECT_EQ(tracers_in(rows), six);
    for (const json& row : rows) EXPECT_EQ(row["counters"], rows[0]["counters"]) << row["tracer"];
}

TEST(Tracers, PacketsAreTimedByTheStackAlone) {
    const auto rows = [](const Words& more) {
        Words words{"bench", "cornell", "--json", "--size", "16x12", "--rounds", "1", "--warmup", "0"};
        words.insert(words.end(), more.begin(), more.end());
        return json::parse(run_kdscope(words).out);
    };
    const json packets = rows({"--tracer", "cpu-packet", "--packet", "8"});
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0]["traversal"], "stack");
    EXPECT_EQ(packets[0]["packet"], 8);
    EXPECT_EQ(rows({"--tracer", "cpu-packet", "--traversal", "restart"}).size(), 1u) << "asked for by name";
    const json wide = rows({"--tracer", "cpu-wide"});
    EXPECT_EQ(wide.size(), traversals().size() - 1) << "all but naive";
    EXPECT_TRUE(wide[0]["packet"].is_null());
}

TEST(Tracers, VerifyHoldsThemTogether) {
    const auto outcome = run_all({"verify", "cornell", "--json", "--size", "16x16", "--adversarial", "130"});
    if (!outcome) GTEST_SKIP() << "NO CONTEXT";
    const json report = json::parse(outcome->out)[0];
    EXPECT_EQ(tracers_in(report["rows"]), six);
    std::map<std::string, std::set<std::string>> builders_of, walks_of;
    std::set<int> packets;
    for (const json& row : report["rows"]) {
        const auto tracer = row["tracer"].get<std::string>();
        builders_of[tracer].insert(row["builder"].get<std::string>());
        walks_of[tracer].insert(row["traversal"].get<std::string>());
        EXPECT_EQ(row["instructions"].is_null(), !tracer.starts_with("cpu")) << tracer;
        const bool compared = tracer != "cpu" && row["traversal"] != "naive";
        EXPECT_TRUE(!compared || row["counter_mismatches"] == 0) << tracer;
        if (!row["packet"].is_null()) packets.insert(row["packet"].get<int>());
    }
    EXPECT_EQ(packets, (std::set<int>{4, 8, 16}));
    for (const auto& [tracer, met] : builders_of) EXPECT_EQ(met.size() - met.count("-"), builders().size()) << tracer;
    const std::size_t walks = traversals().size() - 1;
    for (const char* tracer : {"cpu", "cpu-wide"}) EXPECT_EQ(walks_of[tracer].size(), walks) << tracer;
    for (const char* tracer : {"gl-fragment", "gl-compute", "gl-wavefront"})
        EXPECT_EQ(walks_of[tracer].size() - walks_of[tracer].count("naive"), walks) << tracer;
    EXPECT_EQ(walks_of["cpu-packet"], (std::set<std::string>{"stack"}));
}

TEST(Tracers, SayWhichWalksTheyRefuseAsTheShadersDo) {
    for (const NamedValue<TracerKind>& tracer : choices::tracers())
        for (const NamedValue<Traversal>& walk : choices::traversals())
            for (const NamedValue<Rules>& rules : choices::rules()) {
                const TraceConfig config{.traversal = walk.value, .rules = rules.value};
                const bool refused = tracer.value == TracerKind::gl_wavefront &&
                                     test::refusal([&] { check_wavefront(config); }) != "accepted";
                EXPECT_EQ(!why_no_walk(tracer.value, config).empty(), refused)
                    << tracer.name << ", " << walk.name << ", " << rules.name;
            }
    EXPECT_EQ(why_no_walk(TracerKind::gl_wavefront, {}), "");
}

}  // namespace
}  // namespace kd
