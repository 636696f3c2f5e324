// What the reports of errortime show to be wrong: with it the command fails.
#pragma once

#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"

namespace kd {

struct ErrorTimeFault {
    ErrorReport report;
    std::string of;    // the scene, or the family of rays
    std::string what;  // with its numbers

    [[nodiscard]] std::string where() const;  // "P1 of ball:9000"
};

/// Traversals that change the image (P1), rays that the watertight test loses under robust rules (P2), trees whose cost
/// is not what lines pay (P3), and step budgets that end no walk and change the image (P5). Speed is never wrong.
[[nodiscard]] std::vector<ErrorTimeFault> faults_of(const ErrorTimeResults& results);

}  // namespace kd
