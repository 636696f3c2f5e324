// Rays with their whole state in buffers, and the queues in which they wait for the next kernel: the streaming design
// of Purcell, Buck, Mark and Hanrahan, Ray Tracing on Programmable Graphics Hardware, SIGGRAPH 2002.
#pragma once

#include "renderer/gl/copied_read.h"
#include "renderer/gl/object.h"
#include "renderer/gl/pass_programs.h"

namespace kd {

/// At which 32-bit word of a ray's state each part begins: behind what is asked, what has been found
/// (shaders/wavefront/ray_states.glsl), the walk (keep_walk.glsl) and, behind a walk that has one, the stack
/// (stored_stack.glsl).
struct RayWords {
    static constexpr int found = 12, walk = 24, stack = 32, end_of_walk = 48;
};

/// Words of one ray's state.
[[nodiscard]] int words_per_ray(const TraceConfig& config, const SceneNeeds& needs);

/// InputError where no walk step by step is written for `config`: naive, and rules that are not robust.
void check_wavefront(const TraceConfig& config);

class RayQueues {
  public:
    /// Most rays that are on their way at a time.
    static constexpr int most_rays = 1 << 18;

    /// Room for so many rays, at most most_rays and as many as buffers of `storage_bytes` hold; returns how many.
    int reserve(const GlApi& gl, std::int64_t rays, int words, std::int64_t storage_bytes);

    /// Binds the buffers, with both queues empty.
    void begin(const GlApi& gl) const;

    /// Kernels in turn until no ray is on its way. `plan[i]` is the program that plans queue i, `walk[i]` works at it.
    void run(const GlApi& gl, const std::array<GLuint, 2>& plan, const std::array<GLuint, 2>& walk);

    [[nodiscard]] std::int64_t bytes() const { return bytes_; }

  private:
    GlBuffer states_, counts_, queues_;
    CopiedRead seen_counts_;
    std::int64_t bytes_ = 0;
    std::int64_t words_ = 0;  // of all states
    int rays_ = 0;
};

}  // namespace kd
