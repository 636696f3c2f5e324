// The diagrams of the reports. All but those of P3 are work-precision diagrams: what a method takes along x, how far
// off it is along y, both logarithmic; lower left is better. Those of P3 hold a prediction against what is paid.
#pragma once

#include <string>
#include <vector>

#include "app/error_time/error_time_run.h"
#include "viz/chart.h"

namespace kd {

struct ErrorFigure {
    std::string name;  // of its files
    Chart chart;
};

/// One that would be empty, and why: parts of a sentence.
struct MissingFigure {
    std::string what, why;
};

/// Those of P1: each machine with all its traversals, all machines, and the same in FLIP.
[[nodiscard]] std::vector<ErrorFigure> image_figures(const SceneErrorTime& scene);
/// Those of P2: faults and errors of t for each family.
[[nodiscard]] std::vector<ErrorFigure> hit_figures(const HitReport& report);
/// Families whose errors of t are no figure, and why.
[[nodiscard]] std::vector<MissingFigure> left_out_hit_figures(const HitReport& report);
/// Those of P3: uniform lines, and the rays of a frame.
[[nodiscard]] std::vector<ErrorFigure> prediction_figures(const SceneErrorTime& scene);
/// Those of P4: SAH cost and frame time over build time.
[[nodiscard]] std::vector<ErrorFigure> build_figures(const SceneErrorTime& scene);
/// Those of P5: bounces, and step budgets, where they were measured.
[[nodiscard]] std::vector<ErrorFigure> truncation_figures(const SceneErrorTime& scene);
/// Those of P6: one for each effect.
[[nodiscard]] std::vector<ErrorFigure> effect_figures(const SceneErrorTime& scene);

}  // namespace kd
