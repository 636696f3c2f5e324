// The reports of error against run time, measured: what applies to each scene, within a time to aim at.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "app/error_time/report_names.h"
#include "app/session.h"
#include "renderer/gl/context.h"
#include "renderer/measure/error_time/effect_report.h"
#include "renderer/measure/error_time/hit_report.h"
#include "renderer/measure/error_time/image_report.h"
#include "renderer/measure/error_time/tree_report.h"
#include "renderer/measure/error_time/truncation_report.h"
#include "renderer/measure/measured_on.h"

namespace kd {

/// P1 image error, P2 hit error, P3 predicted against paid, P4 build time against quality, P5 paths and walks that end
/// early, P6 sampled light.
enum class ErrorReport { p1, p2, p3, p4, p5, p6 };
inline constexpr std::array<std::string_view, 6> error_report_names{"P1", "P2", "P3", "P4", "P5", "P6"};

/// Of whole frames by every machine.
[[nodiscard]] constexpr bool traces_by_machines(ErrorReport report) {
    return report == ErrorReport::p1 || report == ErrorReport::p5 || report == ErrorReport::p6;
}

struct ErrorTimeConfig {
    std::set<ErrorReport> reports{ErrorReport::p1, ErrorReport::p2, ErrorReport::p3,
                                  ErrorReport::p4, ErrorReport::p5, ErrorReport::p6};
    double seconds = 360;  // to aim at, for all reports of all scenes
    bool quick = false;
    std::vector<TracerKind> tracers{TracerKind::cpu, TracerKind::gl_fragment};  // of P1, P5 and P6
    bool gl_demanded = false;                                                   // then its absence is an error
    ContextKind context = ContextKind::automatic;
    std::vector<Traversal> traversals;  // of P1 and P5; P6 has the first of them

    [[nodiscard]] bool wants(ErrorReport report) const { return reports.contains(report); }
    /// One of traces_by_machines().
    [[nodiscard]] bool wants_machines() const { return std::ranges::any_of(reports, traces_by_machines); }
};

/// What was left out of a scene's reports, and why: one sentence.
struct LeftOut {
    ErrorReport report;
    std::string why;
};

struct SceneErrorTime {
    Session session;       // scene, tree and tracing that were measured
    std::string contents;  // "300 triangles, ..."
    ReportName name;
    std::optional<ImageReport> images;
    std::optional<TreeReport> trees;  // P3 and P4 share their trees
    std::optional<TruncationReport> truncation;
    std::optional<EffectReport> effects;
    std::vector<LeftOut> left_out;
    std::vector<std::string> notes;  // "restart on cpu: 312 pixels unfinished: step cap"
};

struct ErrorTimeResults {
    ErrorTimeConfig config;
    std::vector<SceneErrorTime> scenes;
    std::optional<HitReport> hits;
    MeasuredOn on;
    double seconds = 0;  // that all of it took
};

/// A scene as it was opened, with the words that asked for it.
struct OpenedScene {
    Session session;
    FlatScene scene;
};

/// `progress` gets the fraction done and what runs. Interrupted where stopped; ContextError where GL was demanded and
/// is not there.
[[nodiscard]] ErrorTimeResults run_error_time(const ErrorTimeConfig& config, const std::vector<OpenedScene>& scenes,
                                              const std::function<void(float, const std::string&)>& progress,
                                              const std::stop_token& stop);

}  // namespace kd
