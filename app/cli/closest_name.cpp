#include "app/cli/closest_name.h"

#include <algorithm>
#include <numeric>

namespace kd {

namespace {

/// Levenshtein's distance, by rows of its table.
std::size_t edits_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string> closest_name(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t most_edits = 2, longest_word = 200;
    if (word.size() > longest_word) return std::nullopt;
    // A number is not misspelt: whoever wrote 12 did not mean 16.
    if (word.find_first_not_of("0123456789.+-") == std::string_view::npos) return std::nullopt;
    std::optional<std::string> closest;
    std::size_t fewest = std::min(most_edits, word.size() / 2) + 1;
    for (const std::string& name : known)
        if (const std::size_t edits = edits_between(word, name); edits < fewest) {
            fewest = edits;
            closest = name;
        }
    return closest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    const std::optional<std::string> closest = closest_name(word, known);
    return closest ? " (did you mean " + *closest + "?)" : "";
}

}  // namespace kd
