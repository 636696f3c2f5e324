// Running the command line inside of a test.
#pragma once

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/cli.h"

namespace kd::test {

struct Outcome {
    int code;
    std::string out, err;
};

inline Outcome run_kdscope(std::vector<std::string> arguments, std::stop_token stop = {}) {
    std::ostringstream out, err;
    CommandContext context{out, err, false, std::move(stop)};
    const int code = run_cli(std::move(arguments), context);
    return {code, out.str(), err.str()};
}

/// Fails the test unless `outcome` is exit code 2 with one line on stderr that holds every one of `words`.
inline void expect_usage_error(const Outcome& outcome, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("kdscope: ")) << outcome.err;
    for (const std::string& word : words)
        EXPECT_NE(outcome.err.find(word), std::string::npos) << word << "\n" << outcome.err;
}

/// An empty folder for the running test, and what lies in it.
class TestFolder {
  public:
    TestFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::path(KD_TEST_OUTPUT_DIR) / "app" /
                (std::string(test->test_suite_name()) + "." + test->name());
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    [[nodiscard]] std::string folder() const { return path_.string(); }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename());
        std::ranges::sort(names);
        return names;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace kd::test
