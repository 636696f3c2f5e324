// What tests hold the pages of reports to: numbers that stand in tables, links that lead somewhere.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>

#include "renderer/io/file.h"

namespace kd::test {

/// Whole words alone: not the 1 of "P1".
inline std::set<std::string> numbers_in(const std::string& text) {
    static const std::regex number("(^|[^A-Za-z0-9._])([0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?)");
    std::set<std::string> numbers;
    for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) numbers.insert(i->str(2));
    return numbers;
}

/// What a reader sees of a page: without style and tags.
inline std::string visible(const std::string& html) {
    const std::string body = html.substr(html.find("<body>"));
    return std::regex_replace(body, std::regex("<[^>]*>"), " ");
}

/// Every link of the folder's page leads to a file beside it.
inline void expect_links_to_exist(const std::filesystem::path& folder) {
    const std::string page = read_file(folder / "index.html");
    static const std::regex link("(?:href|src)=\"([^\"]*)\"");
    int links = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), link), end; i != end; ++i, ++links) {
        const std::string file = i->str(1);
        EXPECT_FALSE(file.starts_with("/") || file.find(':') != std::string::npos) << file;
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    }
    EXPECT_GT(links, 2);
}

}  // namespace kd::test
