// The project's shaders with a fault in one of them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace kd::test {

/// A folder of this test's own with all shaders, in which `file` has `to` instead of the first `from`.
inline std::filesystem::path shaders_with(const std::string& file, const std::string& from, const std::string& to) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("shaders of ") + test->name();
    std::ranges::replace(name, '/', ' ');
    const std::filesystem::path folder = std::filesystem::path(KD_TEST_OUTPUT_DIR) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::copy(std::filesystem::path(KD_SOURCE_DIR) / "shaders", folder,
                          std::filesystem::copy_options::recursive);
    std::ifstream in(folder / file);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << file << " has no '" << from << "'";
    if (at != std::string::npos) std::ofstream(folder / file) << text.replace(at, from.size(), to);
    return folder;
}

}  // namespace kd::test
