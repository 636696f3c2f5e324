// Whether what is left out is missed: frames with each feature put back against the frame without.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/gl/context.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/scene/needs.h"

namespace kd {

struct NeedsCheckConfig : MachineChoice {
    int width = 512, height = 512;
    TraceConfig trace;  // without its forced features
    std::vector<Traversal> traversals{Traversal::stack};
};

/// One feature put back; pixels that differ in any bit.
struct NeedsCheckRow {
    std::string tracer, context, traversal, feature;  // feature "all" for all of them at once
    std::int64_t pixels = 0;
    std::int64_t colours = 0, hits = 0, counters = 0;  // of the picture and its primary rays
    std::array<std::int64_t, pass_count> others{};     // hits or counters of the other rays: told, not judged

    [[nodiscard]] bool good() const { return pixels > 0 && colours + hits + counters == 0; }
};

struct NeedsCheckReport {
    std::vector<NeedsCheckRow> rows;
    std::vector<std::string> notes;  // contexts that are not there, walks refused and why
    bool complete = true;            // false where stopped before the end

    /// At least one feature was put back, and nothing differs.
    [[nodiscard]] bool passed() const;
};

/// What `with` has otherwise than `without`.
[[nodiscard]] NeedsCheckRow compare_frames(const Frame& without, const Frame& with);

/// `progress` gets the fraction done and what is being checked.
[[nodiscard]] NeedsCheckReport check_needs(const FlatScene& scene, const KdTree& tree, const NeedsCheckConfig& config,
                                           const std::function<void(float, const std::string&)>& progress = {},
                                           std::stop_token stop = {});

}  // namespace kd
