// Pixels that are left without an answer are told by the commands that trace frames, those that time frames without
// counters too.

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/choices.h"
#include "app/error_time/error_time_run.h"
#include "app/frame/counted_frame.h"
#include "app/paper/paper_run.h"
#include "renderer/io/file.h"
#include "renderer/kdtree/build.h"
#include "renderer/scene/procedural.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using nlohmann::json;
using test::run_kdscope;
using test::TestFolder;

TEST(UnfinishedNote, RenderTellsTheMapThatShowsThem) {
    const TestFolder folder;
    std::vector<std::string> arguments{"render",      "ball:1000", "-o",     folder.file("a.png"),
                                       "--size",      "64x48",     "--json", folder.file("a.json"),
                                       "--traversal", "restart"};
    const auto robust = run_kdscope(arguments);
    ASSERT_EQ(robust.code, 0) << robust.err;
    EXPECT_EQ(robust.out.find("unfinished"), std::string::npos) << robust.out;
    EXPECT_EQ(json::parse(read_file(folder.file("a.json")))["unfinished"]["pixels"], 0);

    arguments.insert(arguments.end(), {"--rules", "first-edition"});
    const auto published = run_kdscope(arguments);
    ASSERT_EQ(published.code, 0) << published.err;
    EXPECT_NE(published.out.find(" unfinished: step cap; see --map exit"), std::string::npos) << published.out;
    const json unfinished = json::parse(read_file(folder.file("a.json")))["unfinished"];
    EXPECT_GT(unfinished["pixels"], 0);
    EXPECT_EQ(unfinished["pixels"], unfinished["step_cap"]);
    EXPECT_EQ(unfinished["stack_overflow"], 0);
    EXPECT_EQ(unfinished["invalid_ray"], 0);
}

TEST(UnfinishedNote, BenchTellsEachRow) {
    const auto outcome = run_kdscope({"bench", "ball:300", "--size", "32x24", "--rounds", "1", "--warmup", "0",
                                      "--tracer", "cpu", "--rules", "first-edition"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("note: ball:300: restart on cpu: "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" unfinished: step cap"), std::string::npos) << outcome.out;
}

constexpr int too_few_steps = 12;  // for most rays of a ball of 300 triangles

TEST(UnfinishedNote, FramesWithoutCountersHaveACountedOneBefore) {
    const FlatScene scene = flatten(*make_procedural("ball:300"));
    const KdTree tree = build_tree(scene.triangles, {});
    const PinholeCamera camera = pinhole(scene.camera, 24, 16);
    for (const TracerKind kind : {TracerKind::cpu, TracerKind::gl_fragment}) {
        std::unique_ptr<FrameTracer> tracer;
        try {
            tracer = make_frame_tracer(kind, scene, tree, 1, {});
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
        std::vector<std::string> notes;
        note_unfinished(trace_counted(*tracer, {.counters = false}, camera, 24, 16).value(), "whole", notes);
        EXPECT_TRUE(notes.empty()) << notes.front();
        const TraceConfig short_walks{.counters = false, .step_budget = too_few_steps};
        note_unfinished(trace_counted(*tracer, short_walks, camera, 24, 16).value(), "short", notes);
        ASSERT_EQ(notes.size(), 1u) << name_of(kind);
        EXPECT_TRUE(notes[0].starts_with("short: ") && notes[0].ends_with(" pixels unfinished: step cap")) << notes[0];
        std::stop_source stop;
        stop.request_stop();
        EXPECT_FALSE(trace_counted(*tracer, {}, camera, 24, 16, stop.get_token())) << "what stopped is not unfinished";
    }
}

TEST(UnfinishedNote, ErrortimeTellsEachMethodOfP1) {
    const auto notes_with = [](int step_budget) {
        ErrorTimeConfig config;
        config.reports = {ErrorReport::p1};
        config.seconds = 1;
        config.quick = true;
        config.tracers = {TracerKind::cpu};
        config.traversals = {Traversal::stack, Traversal::restart};
        OpenedScene opened;
        opened.session.scene = "ball:300";
        opened.session.trace.step_budget = step_budget;
        opened.scene = flatten(*make_procedural("ball:300"));
        return run_error_time(config, {opened}, [](float, const std::string&) {}, {}).scenes.at(0).notes;
    };
    EXPECT_TRUE(notes_with(0).empty());
    const std::vector<std::string> notes = notes_with(too_few_steps);
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_TRUE(notes[0].starts_with("stack on cpu: ") && notes[0].ends_with(" unfinished: step cap")) << notes[0];
    EXPECT_TRUE(notes[1].starts_with("restart on cpu: ")) << notes[1];
}

TEST(UnfinishedNote, PaperTellsEachContestant) {
    PaperConfig config = paper_config(true);
    config.base.width = config.base.height = 16;
    config.base.trace.step_budget = too_few_steps;
    std::stop_source stop;
    const auto until_prepared = [&](float, const std::string& what, const PaperResults&) {
        if (what == "warming up") stop.request_stop();
    };
    const PaperResults results = run_paper(config, until_prepared, stop.get_token());
    EXPECT_FALSE(results.complete);
    std::vector<std::string> unlike;
    for (const PaperScene& scene : results.scenes)
        for (const PaperTimes& times : scene.times) {
            if (times.method == PaperMethod::naive) continue;  // has no steps
            const std::string name = fmt::format("{} on {}: ", info(times.method).name, scene.name);
            const bool told = std::ranges::any_of(results.notes, [&](const std::string& note) {
                return note.starts_with(name) && note.ends_with(" unfinished: step cap");
            });
            if (!told) unlike.push_back(name);
        }
    EXPECT_EQ(unlike, std::vector<std::string>());
    EXPECT_GE(results.notes.size(), 3 * paper_scenes().size());
}

}  // namespace
}  // namespace kd
