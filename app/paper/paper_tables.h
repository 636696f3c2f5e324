// The paper's numbers as tables and JSON. Every number of the page stands in one of them.
#pragma once

#include <string>
#include <vector>

#include "app/report/json_values.h"
#include "renderer/measure/paper/paper_claims.h"
#include "renderer/measure/paper/paper_results.h"

namespace kd {

/// A table with a title: the page shows its rows, a file holds them as CSV.
struct PaperTable {
    std::string name;   // of its file: "times"
    std::string title;  // for people
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

[[nodiscard]] PaperTable verdict_table(const std::vector<PaperClaim>& claims);
[[nodiscard]] PaperTable time_table(const PaperResults& results);
[[nodiscard]] PaperTable count_table(const PaperResults& results);
[[nodiscard]] PaperTable budget_table(const PaperResults& results);
[[nodiscard]] PaperTable node_size_table(const PaperResults& results);
/// Machine, settings, rounds: what the page says of the run as a whole.
[[nodiscard]] PaperTable run_table(const PaperResults& results, const std::vector<PaperClaim>& claims);

/// Comments with what it was measured on, header, rows.
[[nodiscard]] std::string table_csv(const PaperTable& table, const std::vector<std::string>& comments);

/// All of it, each round's times too.
[[nodiscard]] Json paper_json(const PaperResults& results, const std::vector<PaperClaim>& claims);

}  // namespace kd
