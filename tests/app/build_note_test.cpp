// A tree that stopped at its cap of references is told by the commands that build one, in the same words.

#include "renderer/kdtree/build.h"
#include "tests/app/cli_run.h"

namespace kd {
namespace {

using test::run_kdscope;

/// Whether both streams together have the note, with the cap's usual value and with one that leaves room for no split.
void expect_told_at_the_cap(std::vector<std::string> command, const std::string& prefix) {
    const std::string note = prefix + std::string(reference_cap_note) + "\n";
    const auto told = [&] {
        const test::Outcome outcome = run_kdscope(command);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return (outcome.out + outcome.err).find(note) != std::string::npos;
    };
    EXPECT_FALSE(told()) << command.front();
    command.insert(command.end(), {"--reference-cap", "1"});
    EXPECT_TRUE(told()) << command.front();
}

TEST(BuildNote, RenderTellsTheReferenceCap) {
    const test::TestFolder folder;
    expect_told_at_the_cap({"render", "ball:300", "-o", folder.file("a.png"), "--size", "32x24"}, "note: tree: ");
}

TEST(BuildNote, BenchTellsTheReferenceCap) {
    const std::vector<std::string> bench{"bench",    "ball:300", "--size",   "32x24", "--rounds",    "1",
                                         "--warmup", "0",        "--tracer", "cpu",   "--traversal", "stack"};
    expect_told_at_the_cap(bench, "note: ball:300: tree: ");
}

TEST(BuildNote, VerifyTellsTheReferenceCap) {
    const std::vector<std::string> verify{"verify", "ball:300",  "--size", "16x16",       "--tracer",
                                          "cpu",    "--builder", "paper",  "--traversal", "stack"};
    expect_told_at_the_cap(verify, "note: paper: ");
}

TEST(BuildNote, TestsThatCostNothingMakeOneLeafAndThatIsTold) {
    const auto told = [](const std::vector<std::string>& more) {
        std::vector<std::string> command{"stats", "ball:300", "--size", "8x8"};
        command.insert(command.end(), more.begin(), more.end());
        return run_kdscope(command).out.find("where tests cost nothing no split pays") != std::string::npos;
    };
    EXPECT_TRUE(told({"--intersection-cost", "0"}));
    EXPECT_TRUE(told({"--intersection-cost", "0", "--builder", "spatial-median"}));
    EXPECT_FALSE(told({"--intersection-cost", "0.1"}));
    EXPECT_FALSE(told({"--intersection-cost", "0", "--leaf-size", "1000"})) << "it would be a leaf anyway";
}

}  // namespace
}  // namespace kd
