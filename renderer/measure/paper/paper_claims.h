// The paper's claims, each with the number that decides it.
#pragma once

#include <string>
#include <vector>

#include "renderer/measure/paper/paper_results.h"
#include "renderer/measure/paper/paper_verdict.h"

namespace kd {

struct PaperClaim {
    std::string id;       // "E1b", "E3a scatter"
    std::string where;    // section or figure of the paper
    std::string claim;    // what it says
    std::string measure;  // what our number is
    MedianInterval value;
    Accepted accepted;
    PaperVerdict verdict = PaperVerdict::undecided;
    std::string reason = {};
};

/// All claims in the paper's order, judged by what was measured so far. What only a GPU can decide is undecided where
/// the shaders ran on the CPU, with the number told all the same.
[[nodiscard]] std::vector<PaperClaim> judge_claims(const PaperResults& results);

/// True where a claim that times decide and everybody asks for (E1a, E1b, E2a, E3b) is open though its tracers were
/// timed: more rounds narrow its interval.
[[nodiscard]] bool wants_rounds(const PaperResults& results);

}  // namespace kd
