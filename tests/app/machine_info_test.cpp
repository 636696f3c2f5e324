// What a measurement was made on, as this machine tells it.

#include "app/report/machine_info.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <thread>

namespace kd {
namespace {

TEST(MachineInfo, TellsTheThreadsOfASoftwareRenderer) {
    const char* before = std::getenv("LP_NUM_THREADS");
    const std::string kept = before ? before : "";
    const auto threads_of = [](bool software) {
        MeasuredOn on;
        note_gl(on, "llvmpipe", "4.5", software);
        return on.gl_threads;
    };
    ::setenv("LP_NUM_THREADS", "3", 1);
    EXPECT_EQ(threads_of(true), "3 (LP_NUM_THREADS)");
    EXPECT_EQ(threads_of(false), "") << "a GPU has no such number";
    ::unsetenv("LP_NUM_THREADS");
    EXPECT_EQ(threads_of(true), std::to_string(std::thread::hardware_concurrency()) + " (one a core)");
    if (before) ::setenv("LP_NUM_THREADS", kept.c_str(), 1);
    MeasuredOn on;
    on.gl_threads = "3 (LP_NUM_THREADS)";
    const std::vector<std::string> lines = on.lines();
    EXPECT_NE(std::ranges::find(lines, "gl_threads: 3 (LP_NUM_THREADS)"), lines.end());
}

}  // namespace
}  // namespace kd
