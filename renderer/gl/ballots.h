// Lanes counted by the machine itself, by ballots in a fragment shader.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"
#include "renderer/gl/gl_api.h"
#include "renderer/trace/trace_config.h"

namespace kd {

/// Lanes cannot be counted; what() says why, in one line.
struct BallotError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What the driver offers for it.
struct BallotSupport {
    enum class Kind { none, arb, khr };
    Kind kind = Kind::none;
    bool multiprocessors = false;  // GL_NV_shader_thread_group tells which one runs a pixel

    /// "GL_ARB_shader_ballot, GL_NV_shader_thread_group"; "" for none.
    [[nodiscard]] std::string extensions() const;
};
[[nodiscard]] BallotSupport ballot_support(const GlApi& gl);

/// True where the rays of `config` can be walked by a loop that counts its lanes: the traversals of the tree under the
/// robust rules.
[[nodiscard]] bool has_ballot_loop(const TraceConfig& config);

/// What the shader says of one pixel. `led` counts the iterations in which this lane was the lowest one at work, and
/// `led_lanes` the lanes at work in them, [0] at interior nodes and [1] at leaves: sums over a group are the group's
/// own.
struct LaneBallots {
    std::uint32_t led[2] = {0, 0};
    std::uint32_t led_lanes[2] = {0, 0};
    std::uint32_t group = 0;  // number of one of the group's pixels, in rows
    std::uint32_t lane = 0;
    std::uint32_t multiprocessor = 0;
};

struct BallotLayer {
    int group_size = 0;  // lanes of a group, W
    bool tells_multiprocessors = false;
    Image<LaneBallots> lanes;
    Image<Hit> hit;
    Image<RayCounters> counters;
};

}  // namespace kd
