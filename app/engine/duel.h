// CPU against GPU: the same frame by both in turn, again and again, while nobody works with the window.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <string>

#include "app/frame/frame_time.h"
#include "renderer/measure/timing.h"
#include "renderer/measure/timing_ratio.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/traversal.h"

namespace kd {

/// One frame by the CPU and the same by the GPU, now the one first and now the other.
struct DuelRound {
    TimeSample cpu, gl;
};

/// What a round of the duel needs to know and finds out.
struct DuelReply {
    DuelRound round;
    int width = 0, height = 0;
    int scale = 1;
    std::int64_t rays = 0;
    std::string cpu_clock, gl_clock;
    SetupTimes gl_setup;
};

struct DuelState {
    int width = 0, height = 0;     // of the frame timed
    int scale = 1;                 // 1 = as large as the picture, 2 = half of it along each side
    bool chosen = false;           // that scale by a person, not by the program
    std::int64_t rays = 0;         // that one frame traces, all passes
    std::deque<DuelRound> rounds;  // newest last, all of the same frame
    TimeSummary cpu, gl;
    std::array<TimeSummary, pass_count> passes;
    MedianInterval ratio;          // CPU time over GPU time, round by round
    double clock_discrepancy = 0;  // of the GPU's, as TimedRounds has it
    std::string cpu_clock, gl_clock;
    SetupTimes gl_setup;                     // of the configuration timed
    Traversal traversal = Traversal::stack;  // of the frame timed
    bool outdated = true;                    // the rounds are of a frame that is no longer shown
    bool running = false;

    /// Drops the oldest beyond `history` rounds and summarises again.
    void add(const DuelRound& round);
    /// Rays per second, in millions, of a machine that takes `time` for the frame; 0 while nothing was measured.
    [[nodiscard]] double mrays_per_s(const TimeSummary& time) const;
    /// Enough rounds of both machines to say who is faster.
    [[nodiscard]] bool decided() const { return ratio.sure(); }
    static constexpr int least_rounds = MedianInterval::least_samples;
    static constexpr std::size_t history = 60;
};

/// The scale at which frames are timed unless a person chooses: the finest at which one is predicted to take no longer
/// than half a second, then kept; only where one would take longer than two seconds a coarser one follows. `before` is
/// the scale so far, 0 where scene or picture size are new.
[[nodiscard]] int duel_scale(int before, const std::function<double(int)>& predicted_ms);

}  // namespace kd
