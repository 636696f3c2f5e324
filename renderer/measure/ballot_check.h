// The lanes that a machine counts by itself, held against those that are computed from its rays' walks.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/gl/ballots.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/measure/walk_recorder.h"
#include "renderer/trace/lockstep.h"

namespace kd {

struct BallotReport {
    int group_size = 0;  // lanes of a group, W
    /// The tile of pixels that every group is made of, as the shader tells; 0 where the groups are no such tiles.
    int tile_width = 0, tile_height = 0;
    std::int64_t rays = 0;
    std::int64_t groups = 0;  // of pixels, once for each round in which they have a ray or the machine did something
    std::int64_t differ = 0;  // groups whose iterations or active lanes are not the computed ones
    std::int64_t unlike = 0;  // rays whose hit or counters are not the CPU's
    GroupTally measured, computed;
    std::string first_difference;  // empty where none
    std::map<std::uint32_t, std::int64_t>
        multiprocessors;  // pixels that each ran; empty where the driver does not tell
    /// Of the first round of rays, each group's efficiency on all of its pixels; NaN where it has no ray.
    Image<float> measured_map, computed_map;

    [[nodiscard]] bool exact() const { return differ == 0 && unlike == 0 && groups > 0; }
};

/// Of each pixel what its ray does, as Walk::phases() tells it; null where it has none.
using PixelPhases = std::vector<const std::vector<std::uint32_t>*>;

/// Adds the groups of one drawing: what was measured of each, and what its pixels' rays come to. `paint` makes the
/// report's maps of it.
void compare_groups(const BallotLayer& layer, const PixelPhases& walks, Schedule loop, BallotReport& report,
                    bool paint);

/// `tracer` must hold the request's scene and tree (GlTracer::upload), whose configuration must be one that
/// has_ballot_loop(); of reflections the first bounce is walked. `loop` is not lockstep. BallotError; nothing in the
/// report where stopped.
[[nodiscard]] BallotReport check_ballots(GlTracer& tracer, const WalkRequest& request, Schedule loop,
                                         std::stop_token stop = {});

}  // namespace kd
