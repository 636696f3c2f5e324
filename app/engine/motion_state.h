// The motion of the scene in the window: what a person wishes of it, and what its frames came to.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "app/session.h"
#include "renderer/measure/motion/pipeline_stats.h"

namespace kd {

/// Schedules that the window has. Its trees are built on a thread of their own, so that `serial` is there what
/// `on_demand` is.
inline constexpr std::array window_schedules{FrameSchedule::pipelined, FrameSchedule::on_demand};

struct MotionWish {
    bool playing = false;
    double speed = 1.0;  // seconds of the motion in a second, above 0
    bool loop = true;    // rather than ending at the last pose
    FrameSchedule schedule = FrameSchedule::pipelined;
    bool refit = false;  // trees of poses: the planes of the tree at time 0 are kept (renderer/kdtree/refit.h)

    bool operator==(const MotionWish&) const = default;
};

/// Of the poses of one scene under one configuration.
struct MotionState {
    static constexpr std::size_t most_frames = 32;  // that are kept of a run

    bool playing = false;  // poses follow each other
    bool ended = false;    // the last pose is shown, and the motion is not to begin again
    bool posing = false;   // a pose that was asked for, not played, is being made
    /// Frames played last, oldest first; seconds by the steady clock.
    PipelineRun recent;
    /// Of each schedule, as it was when it was played last; by FrameSchedule.
    std::array<PipelineStats, frame_schedule_names.size()> stats;
    std::int64_t played = 0;  // number of the newest frame of `recent`, from 1
    int made = 0;             // trees of poses, of this scene by these constants
    int refused = 0;          // of these, that were built because refitting was refused
    std::string why_refused;  // the last one
    double first_cost = 0;    // of the tree that refitting keeps the planes of, by the SAH; 0 where there is none
};

}  // namespace kd
