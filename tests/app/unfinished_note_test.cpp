// Pixels that published rules leave without an answer are told by the commands that trace frames.

#include <nlohmann/json.hpp>

#include "renderer/io/file.h"
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

}  // namespace
}  // namespace kd
