// The list of what a scene needs: one row per feature, for the command line, files and the window.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/frame/rendering.h"
#include "app/report/json_values.h"
#include "renderer/measure/needs_costs.h"

namespace kd {

/// What a feature is in a session, and what it costs.
struct NeedRow {
    const FeatureInfo* feature;
    FeatureNeed need;
    bool in_use = false;
    bool gpu_only = false;   // the CPU traces, and has no such thing to leave out
    std::int64_t bytes = 0;  // that it takes, or would take
    std::optional<FeatureTime> time{};

    [[nodiscard]] bool put_back() const { return in_use && !need.needed; }
    /// "needed", "left out", "put back", "GPU only".
    [[nodiscard]] std::string_view state() const;
};

/// All features. `times` are of those that were timed.
[[nodiscard]] std::vector<NeedRow> need_rows(const FlatScene& scene, const KdTree& tree, const SceneFacts& facts,
                                             const Session& session, const std::vector<FeatureTime>& times);

/// "2.1 ms (1.8 – 2.4)", "no difference seen", "too few rounds", or nothing where it was not timed.
[[nodiscard]] std::string saved_text(const NeedRow& row);
/// "1.5 MB", "320 kB"; nothing for 0.
[[nodiscard]] std::string bytes_text(std::int64_t bytes);

/// What was measured, and by what.
struct NeedsReport {
    std::vector<NeedRow> rows;
    int rounds = 0;
    std::string renderer, clock;
};

/// Times every feature that is left out, `rounds` times each (0: none), with progress. InputError, ContextError,
/// Interrupted.
[[nodiscard]] NeedsReport needs_report(const Rendering& rendering, const GlChoices& gl, int rounds,
                                       CommandContext& context);

void print(std::ostream& out, const NeedsReport& report);
[[nodiscard]] Json json_of(const NeedsReport& report);

}  // namespace kd
