#include "renderer/gl/ray_queues.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/gl/ballots.h"
#include "renderer/gl/bindings.h"
#include "renderer/gl/gl_error.h"

namespace kd {

namespace {

/// One queue's counts (shaders/wavefront/queues.glsl).
struct QueueCounts {
    std::array<GLuint, 3> groups{0, 1, 1};
    GLuint taken = 0, pushed = 0;
    std::array<GLuint, 3> unused{};
};
static_assert(sizeof(QueueCounts) == 32);

/// A look waits for the machine, a round too many costs four dispatches of nothing.
constexpr int rounds_between_looks = 8;

GlBuffer make_buffer(const GlApi& gl, std::int64_t bytes) {
    GlBuffer buffer(gl);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_COPY);
    check_gl(gl, fmt::format("making room for {} bytes of rays", bytes));
    return buffer;
}

}  // namespace

int words_per_ray(const TraceConfig& config, const SceneNeeds& needs) {
    const TraversalInfo& info = kd::info(config.traversal);
    if (info.has(walk_stack)) return RayWords::stack + 3 * needs.levels;
    return RayWords::end_of_walk + (info.has(walk_short_stack) ? 4 * config.short_stack : 0);
}

void check_wavefront(const TraceConfig& config) {
    if (has_ballot_loop(config)) return;
    throw InputError(
        fmt::format("tracer gl-wavefront: has no {} under {} rules, but each walk of the tree under robust "
                    "ones; choose one of these, or --tracer gl-compute",
                    info(config.traversal).name, info(config.rules).name));
}

int RayQueues::reserve(const GlApi& gl, std::int64_t rays, int words, std::int64_t storage_bytes) {
    constexpr std::int64_t word = 4;
    const std::int64_t wanted = std::min({rays, std::int64_t(most_rays), storage_bytes / (word * words)});
    const int slots = int(std::max<std::int64_t>(1, wanted));
    if (states_ && std::int64_t(slots) * words <= words_ && slots <= rays_) return slots;
    *this = {};
    words_ = std::int64_t(slots) * words;
    rays_ = slots;
    states_ = make_buffer(gl, word * words_);
    counts_ = make_buffer(gl, 2 * sizeof(QueueCounts));
    queues_ = make_buffer(gl, 2 * word * slots);
    bytes_ = word * words_ + 2 * std::int64_t(sizeof(QueueCounts)) + 2 * word * slots;
    return slots;
}

void RayQueues::begin(const GlApi& gl) const {
    const std::array<QueueCounts, 2> empty{};
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, ray_states, states_.id());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, queue_counts, counts_.id());
    gl.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof empty, empty.data());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, ray_queues, queues_.id());
}

void RayQueues::run(const GlApi& gl, const std::array<GLuint, 2>& plan, const std::array<GLuint, 2>& walk) {
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, counts_.id());
    std::array<QueueCounts, 2> counts{};
    do {
        for (int round = 0; round < rounds_between_looks; ++round)
            for (std::size_t queue = 0; queue < 2; ++queue) {
                gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
                gl.UseProgram(plan[queue]);
                gl.DispatchCompute(1, 1, 1);
                gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
                gl.UseProgram(walk[queue]);
                gl.DispatchComputeIndirect(GLintptr(queue * sizeof(QueueCounts)));
            }
        gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
        seen_counts_.read(gl, counts_, std::as_writable_bytes(std::span(counts)));
    } while (counts[0].pushed > 0 || counts[1].pushed > 0);
    gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

}  // namespace kd
