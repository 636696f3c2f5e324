#include "app/report/sweep_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <ostream>

#include "app/cli/text_table.h"
#include "viz/csv.h"

namespace kd {

namespace {

/// "0 (< 1.5e-03)" or "0.193"; "0 (< 2.2e-02) + 64 flagged" where rays were given up, "all 200 flagged".
std::string share_text(const SweepRow& row) {
    if (row.answered() == 0) return fmt::format("all {} flagged", row.n);
    const std::string share =
        row.missed + row.wrong > 0 ? fmt::format("{:.3g}", row.share()) : fmt::format("0 (< {:.1e})", row.upper95);
    return row.given_up > 0 ? fmt::format("{} + {} flagged", share, row.given_up) : share;
}

std::string ulp_text(const SweepRow& row) {
    if (row.worst_ulp < 0) return "-";
    return fmt::format("{:.3g} / {:.3g}", row.p99_ulp, row.worst_ulp);
}

void print_table(std::ostream& out, const SweepReport& report,
                 const std::function<std::string(const SweepRow&)>& cell) {
    const std::vector<SweepMethod> methods = report.methods();
    std::vector<TextTable::Column> columns{{parameter_text(report.parameter, report.unit)}, {"rays"}};
    for (const SweepMethod& method : methods) columns.push_back({method.name()});
    TextTable table(columns);
    for (std::size_t i = 0; i < report.rows.size();) {
        const double value = report.rows[i].value;
        std::vector<std::string> cells{fmt::format("{:g}", value), fmt::format("{}", report.rows[i].n)};
        cells.resize(columns.size(), "-");
        for (; i < report.rows.size() && report.rows[i].value == value; ++i) {
            const auto column = std::ranges::find(methods, report.rows[i].method) - methods.begin();
            cells[2 + std::size_t(column)] = cell(report.rows[i]);
        }
        table.add_row(cells);
    }
    table.print(out);
}

/// A negative one says that nothing was hit.
std::optional<double> known(double value) { return value < 0 ? std::nullopt : std::optional(value); }

}  // namespace

std::string parameter_text(const std::string& parameter, const std::string& unit) {
    return unit.empty() ? parameter : fmt::format("{} ({})", parameter, unit);
}

void print(std::ostream& out, const SweepReport& report) {
    out << fmt::format("{} {}\n\nShare of the rays that miss or hit the wrong triangle (below 3/n where none does)\n",
                       report.id, report.title);
    print_table(out, report, share_text);
    if (std::ranges::any_of(report.rows, [](const SweepRow& row) { return row.given_up > 0; }))
        out << "flagged: rays that were given up, at the step budget or with a full stack; the share is of the "
               "others\n";
    out << "\nError of t in ulp: 99 % of the hits, and the worst\n";
    print_table(out, report, ulp_text);
    for (const std::string& note : report.notes) out << "note: " << note << '\n';
}

std::string sweep_csv(const SweepReport& report) {
    std::string text = "case,parameter,unit,value,tracer,context,rules,traversal,n,missed,wrong,given_up,share,upper95,"
                       "p99_ulp,worst_ulp,seconds\n";
    for (const SweepRow& row : report.rows) {
        const SweepMethod& m = row.method;
        text += csv_row(report.id, report.parameter, report.unit, row.value, m.tracer, m.context, m.rules, m.traversal,
                        row.n, row.missed, row.wrong, row.given_up, row.share(), row.upper95, known(row.p99_ulp),
                        known(row.worst_ulp), row.seconds);
    }
    return text;
}

Json sweep_json(const SweepReport& report) {
    Json rows = Json::array();
    for (const SweepRow& row : report.rows)
        rows.push_back({{"value", row.value},
                        {"method", row.method.name()},
                        {"tracer", row.method.tracer},
                        {"context", row.method.context},
                        {"rules", row.method.rules},
                        {"traversal", row.method.traversal},
                        {"n", row.n},
                        {"missed", row.missed},
                        {"wrong", row.wrong},
                        {"given_up", row.given_up},
                        {"share", row.share()},
                        {"upper95", row.upper95},
                        {"p99_ulp", or_null(row.p99_ulp)},
                        {"worst_ulp", or_null(row.worst_ulp)},
                        {"seconds", row.seconds}});
    return {{"case", report.id},
            {"title", report.title},
            {"parameter", report.parameter},
            {"unit", report.unit},
            {"logarithmic", report.logarithmic},
            {"values", report.values},
            {"rows", rows},
            {"notes", report.notes}};
}

}  // namespace kd
