#include "app/report/stability_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <set>

#include "app/cli/counted.h"
#include "app/cli/text_table.h"
#include "renderer/cpu/cpu_tracer.h"

namespace kd {

namespace {

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass: return "pass";
        case Verdict::fail: return "fail";
        case Verdict::exempt: break;
    }
    return "exempt";
}

/// Nothing follows from so few that all the others may be wrong.
std::string bound_text(const StabilityRow& row) { return row.upper95 < 1 ? fmt::format("{:.1e}", row.upper95) : "-"; }

}  // namespace

void StabilityTable::print_new(const StabilityReport& so_far) {
    using enum TextTable::Align;
    // As wide as what most cases hold, since those that come later are not known yet.
    TextTable table({{"case", left},
                     {"tracer", left, false, 11},
                     {"context", left},
                     {"traversal", left, false, 11},
                     {"n", right, false, 7},
                     {"mismatches"},
                     {"at most (95 %)"},
                     {"worst ulp"},
                     {"seconds"},
                     {"verdict", left}});
    for (std::size_t i = rows_; i < so_far.rows.size(); ++i) {
        const StabilityRow& row = so_far.rows[i];
        table.add_row({row.id, row.tracer, row.context, row.traversal, fmt::format("{}", row.n),
                       fmt::format("{}", row.mismatches), bound_text(row),
                       row.worst_ulp >= 0 ? fmt::format("{:.3g}", row.worst_ulp) : "-",
                       fmt::format("{:.2f}", row.seconds), name_of(row.verdict)});
    }
    if (so_far.rows.size() > rows_)
        table.print(out_, usual_width, rows_ == 0 ? TextTable::Titles::shown : TextTable::Titles::hidden);
    out_.flush();
    cases_ = so_far.cases_run;
    rows_ = so_far.rows.size();
}

void print_reasons(std::ostream& out, const StabilityReport& report) {
    std::set<std::string> told;  // rows that fail for one reason are told once
    for (const StabilityRow& row : report.rows)
        if (row.verdict != Verdict::pass && told.insert(row.id + row.reason).second)
            out << fmt::format("{} {} {} {} {}: {}\n", row.id, name_of(row.verdict), row.traversal, row.tracer,
                               row.context, row.reason);
}

void print_summary(std::ostream& out, const StabilityReport& report) {
    if (std::ranges::any_of(report.rows, [](const StabilityRow& row) { return row.tracer == "-"; }))
        out << "tracer -: a check beside the tracers, of n things; of fewer than 4 no bound follows for others\n";
    for (const std::string& note : report.notes) out << "note: " << note << '\n';
    print_reasons(out, report);
    const auto failures = std::ranges::count(report.rows, Verdict::fail, &StabilityRow::verdict);
    double rows = 0;
    for (const StabilityRow& row : report.rows) rows += row.seconds;
    out << fmt::format("{:.2f} s in the rows above; {:.2f} s before them in building trees and in the oracles (brute "
                       "force over all triangles); the CPU traces with {}\n",
                       rows, report.preparing_seconds, cpu_target_name());
    out << fmt::format("{}, {}, {} failed: {}\n", counted(report.cases_run, "case"), counted(report.rows.size(), "row"),
                       failures, report.passed() ? "passed" : "failed");
}

Json stability_json(const StabilityReport& report) {
    Json cases = Json::array();
    for (const StabilityRow& row : report.rows)
        cases.push_back({{"case", row.id},
                         {"tracer", row.tracer},
                         {"context", row.context},
                         {"traversal", row.traversal},
                         {"n", row.n},
                         {"mismatches", row.mismatches},
                         {"upper95", row.upper95},
                         {"worst_ulp", or_null(row.worst_ulp)},
                         {"seconds", row.seconds},
                         {"verdict", name_of(row.verdict)},
                         {"reason", row.reason}});
    return {{"passed", report.passed()},
            {"cases_run", report.cases_run},
            {"preparing_seconds", report.preparing_seconds},
            {"cases", cases},
            {"notes", report.notes}};
}

}  // namespace kd
