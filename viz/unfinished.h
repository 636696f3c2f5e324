// Pixels whose rays were given up: they ended neither with a hit nor with a miss.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "renderer/trace/frame.h"

namespace kd {

struct UnfinishedPixels {
    std::int64_t pixels = 0;  // with one such ray or more
    /// By the reason that is highest among a pixel's rays, KD_EXIT_...; those of answers stay 0.
    std::array<std::int64_t, KD_EXIT_INVALID_RAY + 1> by_reason{};
    Pass rays = Pass::rt_prim;  // the pass that gave up most of them

    bool operator==(const UnfinishedPixels&) const = default;
};

[[nodiscard]] UnfinishedPixels count_unfinished(const Frame& frame);

/// "312 pixels unfinished: step cap", or with the number of each reason where there are several; empty where all rays
/// came to an end.
[[nodiscard]] std::string unfinished_text(const UnfinishedPixels& unfinished);

}  // namespace kd
