// What every traversal costs the same rays, counted: visits, tests, and ways back.
#pragma once

#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// A traversal with what it can choose, as a row of tables.
struct WalkVariant {
    std::string name;  // "short stack, 4 entries"
    TraceConfig config;
    std::string published;  // interior visits over the stack's in the literature, with whose they are; may be empty
};

/// Stack, the same from entry points, kd-restart, push-down, short stacks of 1, 2, 4 and 8 entries, kd-backtrack, ropes
/// plain, optimised, and from the leaf of the eye. All else is as in `base`.
[[nodiscard]] std::vector<WalkVariant> walk_variants(const TraceConfig& base);

struct WalkRow {
    WalkVariant variant;
    std::array<CounterTotals, pass_count> totals;  // by kind of ray

    [[nodiscard]] std::uint64_t interior(Pass rays) const;
    /// Interior visits over those of `stack`; 0 where that has none.
    [[nodiscard]] double of(const WalkRow& stack, Pass rays) const;
};

/// The frame that is walked.
struct WalkTableTask {
    const FlatScene& scene;
    const KdTree& tree;
    TraceConfig config;
    PinholeCamera camera;
    int width = 0, height = 0;
    int threads = 0;
};

/// A row for each variant, the stack first; what is there where stopped.
[[nodiscard]] std::vector<WalkRow> walk_table(const WalkTableTask& task, std::stop_token stop = {});

}  // namespace kd
