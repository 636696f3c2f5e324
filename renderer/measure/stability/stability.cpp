#include "renderer/measure/stability/stability.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

#include "renderer/geometry/input_error.h"
#include "renderer/measure/stability/case_run.h"
#include "renderer/measure/stability/cases.h"
#include "renderer/measure/timing.h"

namespace kd {

namespace {

std::vector<const StabilityCase*> chosen_cases(const std::vector<std::string>& ids) {
    std::vector<const StabilityCase*> chosen;
    for (const StabilityCase& info : stability_cases())
        if (ids.empty() || std::ranges::find(ids, info.id) != ids.end()) chosen.push_back(&info);
    for (const std::string& id : ids) (void)stability_case(id);
    return chosen;
}

/// "T01 to T65, without T17 and T39": the cases keep their numbers for good, and some are not used.
std::string numbers_used() {
    const auto number = [](const StabilityCase& info) { return std::stoi(std::string(info.id.substr(1))); };
    std::vector<std::string> unused;
    int next = number(stability_cases().front());
    for (const StabilityCase& info : stability_cases()) {
        for (; next < number(info); ++next) unused.push_back(fmt::format("T{:02}", next));
        ++next;
    }
    return fmt::format("{} to {}{}{}", stability_cases().front().id, stability_cases().back().id,
                       unused.empty() ? "" : ", without ", fmt::join(unused, ", "));
}

/// Rows of the case that runs stand in the report while `tell` looks at it.
void tell_with(StabilityReport& report, const std::vector<StabilityRow>& running, const std::function<void()>& tell) {
    const std::size_t finished = report.rows.size();
    report.rows.insert(report.rows.end(), running.begin(), running.end());
    tell();
    report.rows.resize(finished);
}

void keep(StabilityReport& report, std::vector<StabilityRow> rows) {
    for (StabilityRow& row : rows) {
        report.preparing_seconds -= row.seconds;
        report.rows.push_back(std::move(row));
    }
}

}  // namespace

std::span<const StabilityCase> stability_cases() {
    static const std::vector<StabilityCase> table = [] {
        std::vector<StabilityCase> cases{
#define KD_CASE(id) case_##id(),
#include "renderer/measure/stability/case_list.inc"
#undef KD_CASE
        };
        std::ranges::sort(cases, {}, &StabilityCase::id);
        return cases;
    }();
    return table;
}

const StabilityCase& stability_case(std::string_view id) {
    const auto found = std::ranges::find(stability_cases(), id, &StabilityCase::id);
    if (found == stability_cases().end())
        throw InputError(fmt::format("there is no stability case '{}'; there are {}", id, numbers_used()));
    return *found;
}

bool StabilityReport::passed() const {
    return complete && !rows.empty() &&
           std::ranges::none_of(rows, [](const StabilityRow& row) { return row.verdict == Verdict::fail; });
}

StabilityReport run_stability(const StabilityConfig& config, const StabilityProgress& progress, std::stop_token stop) {
    StabilityReport report;
    report.rules = config.rules;
    report.complete = false;
    const std::vector<const StabilityCase*> cases = chosen_cases(config.cases);
    const auto machines = open_machines(config, "checked", report.notes);
    if (!config.contexts.empty() && config.traversals.empty() && !config.long_run && config.rules == Rules::robust)
        report.notes.push_back(fmt::format(
            "on OpenGL stack, restart and backtrack only{}, but for T62, which has all; the others with "
            "--long, or where --traversal names one",
            config.gl.size() > 1 ? " (each tracer after the first by one of these in a case, in turn)" : ""));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto tell = [&](float done, const std::string& doing) {
            const std::string what = fmt::format("{} {}{}", cases[i]->id, cases[i]->title, doing);
            if (progress) progress((float(i) + done) / float(cases.size()), what, report);
        };
        tell(0, "");
        CaseRun run(*cases[i], config, machines, stop, [&](float done, const std::string& doing) {
            tell_with(report, run.rows(), [&] { tell(done, ": " + doing); });
        });
        bool stopped = false;
        report.preparing_seconds += 1e-3 * wall_ms([&] {
                                        try {
                                            cases[i]->run(run);
                                        } catch (const CaseRun::Stopped&) {
                                            stopped = true;
                                        }
                                    });
        keep(report, run.rows());
        if (stopped) return report;
        ++report.cases_run;
    }
    report.complete = true;
    return report;
}

}  // namespace kd
