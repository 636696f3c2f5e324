// Measures a sweep: how many rays each way of tracing loses, and how far t is off, at every value of the parameter.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/measure/ray_machine.h"
#include "renderer/measure/stability/sweep.h"
#include "renderer/trace/rules.h"

namespace kd {

struct SweepConfig : MachineChoice {
    std::string id;                       // of the case
    std::size_t rays = 2000;              // per value, at most
    std::vector<std::string> traversals;  // empty = stack
    unsigned seed = 1;
};

/// One way of tracing: rules on a machine, or the loop over all triangles in double.
struct SweepMethod {
    std::string tracer, context;  // "cpu", "gl-fragment", "double"; "-" but for OpenGL
    std::string rules, traversal;

    /// "robust, cpu"; "double" alone.
    [[nodiscard]] std::string name() const;
    bool operator==(const SweepMethod&) const = default;
};

/// One method at one value.
struct SweepRow {
    double value = 0;
    SweepMethod method;
    std::int64_t n = 0, missed = 0, wrong = 0;
    std::int64_t given_up = 0;            // of n: ended and flagged before their answer, so neither missed nor wrong
    double upper95 = 0;                   // of the share of both; 3 / answered() where there is none
    double worst_ulp = -1, p99_ulp = -1;  // of t, for the hits; negative where nothing was hit
    double seconds = 0;                   // of tracing with counters, which tell what was given up

    [[nodiscard]] std::int64_t answered() const { return n - given_up; }
    /// Of the rays that have an answer.
    [[nodiscard]] double share() const { return answered() > 0 ? double(missed + wrong) / double(answered()) : 0; }
};

struct SweepReport {
    std::string id, title, parameter, unit;
    bool logarithmic = false;
    std::vector<double> values;
    std::vector<SweepRow> rows;      // by value, then by method
    std::vector<std::string> notes;  // contexts that are not there
    bool complete = false;

    /// Those that were measured, in the order of the rows.
    [[nodiscard]] std::vector<SweepMethod> methods() const;
};

/// `progress` gets the fraction done, what runs, and what was measured so far. InputError for a case without a sweep.
[[nodiscard]] SweepReport
run_sweep(const SweepConfig& config,
          const std::function<void(float, const std::string&, const SweepReport&)>& progress = {},
          std::stop_token stop = {});

}  // namespace kd
