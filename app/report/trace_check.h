// The answers to a person's own rays against double precision.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/progress_line.h"
#include "renderer/measure/oracle.h"

namespace kd {

class TraceCheck {
  public:
    /// Finds the exact hits of the rays asked for, in scene units. `scene` and `asked` must outlive it. Interrupted.
    TraceCheck(const FlatScene& scene, std::span<const Ray> asked, int threads, ProgressLine& progress,
               const CommandContext& context);

    /// The rays in the scene's internal units: those to trace.
    [[nodiscard]] std::span<const Ray> rays() const { return rays_; }

    /// Compares what `who` ("restart on cpu") answered; in internal units.
    void compare(const std::string& who, std::span<const Hit> hits, std::span<const RayCounters> counters);

    [[nodiscard]] bool passed() const { return wrong_ == 0; }
    /// "3 of 80 answers are wrong in double precision: 2 missed, 1 t off".
    [[nodiscard]] std::string summary() const;
    /// A line for each wrong answer, the first hundred.
    [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }
    /// "2 of 80 rays are invalid, the first ray 7: ..."; empty where every ray could be traced.
    [[nodiscard]] std::string invalid_text() const;
    /// The rays that some answer to was wrong, as they came.
    [[nodiscard]] std::vector<Ray> failed_rays() const;

  private:
    [[nodiscard]] std::string failure_text(const std::string& who, std::size_t i, const Hit& found,
                                           const JudgedHit& judged) const;

    DoubleOracle oracle_;
    std::span<const Ray> asked_;
    std::vector<Ray> rays_;
    std::vector<f64::Hit> exact_;
    std::vector<bool> failed_, invalid_;  // by some answer
    VerdictCounts counts_{};
    std::int64_t wrong_ = 0;
    std::vector<std::string> failures_;
};

}  // namespace kd
