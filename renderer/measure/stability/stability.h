// The stability suite: cases that break ray tracers, each with its construction, its oracle and what is accepted, run
// on every traversal and every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/build.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/trace/rules.h"
#include "renderer/trace/trace_config.h"

namespace kd {

class CaseRun;

struct StabilityCase {
    std::string_view id;            // "T14"
    std::string_view title;         // "Closed sphere from inside"
    std::string_view construction;  // what is traced
    std::string_view oracle;        // what it is held against
    std::string_view acceptance;    // when it passes
    void (*run)(CaseRun&);
    std::string_view exempt = {};  // why a failure is no failure of the suite; at most three cases have one
};

/// In order of their ids.
[[nodiscard]] std::span<const StabilityCase> stability_cases();

/// The case called `id`, such as "T14". InputError naming those there are.
[[nodiscard]] const StabilityCase& stability_case(std::string_view id);

struct StabilityConfig : MachineChoice {
    std::vector<std::string> cases;       // ids; empty = all
    bool long_run = false;                // all rays of a case instead of a tenth
    std::vector<std::string> traversals;  // empty = all but naive
    Rules rules = Rules::robust;
    NodeEncoding nodes = NodeEncoding::float4;    // of the tracers, where a case does not try both
    std::string builder = BuildConfig{}.builder;  // of the trees, where a case does not name one
    int packet_size = TraceConfig{}.packet_size;  // of CpuMode::packet
    unsigned seed = 1;
};

enum class Verdict { pass, fail, exempt };

struct StabilityRow {
    std::string id;
    std::string tracer, context, traversal;  // "-" where the case has none
    std::int64_t n = 0, mismatches = 0;
    std::int64_t given_up = 0;  // of the mismatches: flagged at the step budget, in a case that is exempt for that
    double upper95 = 0;         // 95 % upper bound of the share of mismatches; 3/n where there is none
    double worst_ulp = -1;      // of t, off the plane of the triangle that was found; negative where none was
    double seconds = 0;         // of tracing and comparing, without the oracle
    Verdict verdict = Verdict::pass;
    std::string reason;  // the first failure, or what was measured; a failing ray in exact hexadecimal floats
};

struct StabilityReport {
    std::vector<StabilityRow> rows;
    std::vector<std::string> notes;  // what was left out
    Rules rules = Rules::robust;     // that all rows were traced under
    int cases_run = 0;               // to their ends
    double preparing_seconds = 0;    // beside those of the rows: trees, and the oracles that rows are held against
    bool complete = true;            // false while it runs, and where stopped before the end
    /// True where something ran, all of it to the end, and no row failed.
    [[nodiscard]] bool passed() const;
};

/// Gets the fraction done, which moves within a case too, what runs, and the rows so far: those of the case that runs
/// are of the rays that it has traced. It is called as each case begins, with the rows of those before it alone.
using StabilityProgress = std::function<void(float, const std::string&, const StabilityReport&)>;

/// InputError for a case that is not known. Where stopped, what was found until then is kept.
[[nodiscard]] StabilityReport run_stability(const StabilityConfig& config, const StabilityProgress& progress = {},
                                            std::stop_token stop = {});

}  // namespace kd
