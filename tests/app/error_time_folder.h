// What tests hold the folders of errortime to: every number of the page stands in a table.
#pragma once

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "renderer/io/file.h"
#include "tests/app/report_page.h"

namespace kd::test {

/// Lines of a table as fields; none of them is quoted here but the first.
inline std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
    static const std::regex field("(?:^|,)(?:\"((?:[^\"]|\"\")*)\"|([^,]*))");
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) continue;
        rows.emplace_back();
        for (std::sregex_iterator i(line.begin(), line.end(), field), end; i != end; ++i)
            rows.back().push_back((*i)[1].matched ? i->str(1) : i->str(2));
    }
    return rows;
}

/// Whether `shown` is `value` to within half a unit of its last digit.
inline bool is_rounded(const std::string& shown, double value) {
    const std::size_t e = std::min(shown.find('e'), shown.size()), point = std::min(shown.find('.'), e);
    const int exponent = e < shown.size() ? std::stoi(shown.substr(e + 1)) : 0;
    const int decimals = point < e ? int(e - point - 1) : 0;
    return std::abs(std::stod(shown) - value) <= 0.5001 * std::pow(10.0, exponent - decimals);
}

/// Numbers that the page shows and that no table of the folder holds by name: none but those of its own sentences.
inline std::set<std::string> stray_numbers(const std::filesystem::path& folder, const std::string& page) {
    std::set<std::string> known{"0.5", "95", "99.9", "1997", "2011", "2020"};
    for (const char* table : {"scenes.csv", "left-out.csv"}) known.merge(numbers_in(read_file(folder / table)));
    std::set<std::pair<std::string, std::string>> tabled;
    for (const auto& row : rows_of(read_file(folder / "numbers.csv"))) {
        known.merge(numbers_in(row[0]));
        tabled.emplace(row[1], row[2]);
    }
    std::set<std::string> strays;
    static const std::regex data("<data value=\"([^\"]*)\">([^<]*)</data>");
    for (std::sregex_iterator i(page.begin(), page.end(), data), end; i != end; ++i)
        if (!tabled.contains({i->str(2), i->str(1)}) || !is_rounded(i->str(2), std::stod(i->str(1))))
            strays.insert(i->str(2));
    const std::string links = "<a [^>]*>[^<]*</a>";  // names of files, which are held to be there
    const std::string rest = std::regex_replace(std::regex_replace(page, data, " "), std::regex(links), " ");
    for (const std::string& number : numbers_in(visible(rest)))
        if (!known.contains(number)) strays.insert(number);
    return strays;
}

/// Every number of the page stands in a table, and every link leads to a file beside it.
inline void expect_whole_page(const std::filesystem::path& folder) {
    const std::string page = read_file(folder / "index.html");
    EXPECT_EQ(stray_numbers(folder, page), std::set<std::string>());
    EXPECT_EQ(stray_numbers(folder, page + "<p>It took 7.31 s, <data value=\"2\">2.5</data>.</p>"),
              (std::set<std::string>{"7.31", "2.5"}))
        << "the check itself can fail";
    expect_links_to_exist(folder);
}

}  // namespace kd::test
