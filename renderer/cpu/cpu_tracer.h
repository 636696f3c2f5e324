// Tracing on the CPU: the shared text, tiles over all cores.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_mode.h"
#include "renderer/kdtree/tree.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/trace_config.h"

namespace kd {

struct SceneView;  // renderer/cpu/scene_view.h

/// Holds what tracing needs beside scene and tree (node boxes, leaves in blocks, ...), made when first asked for.
/// Scene and tree must outlive it. Calls on one tracer must not overlap; each uses as many threads as it is given.
class CpuTracer {
  public:
    CpuTracer(const FlatScene& scene, const KdTree& tree, CpuMode mode = CpuMode::scalar);
    ~CpuTracer();
    CpuTracer(CpuTracer&&) noexcept;

    /// Makes the tables that `config` needs, on `threads` threads (0 = all). False where stopped before the end; the
    /// next call goes on. Called by the others; call it first to keep it out of a timing.
    bool prepare(const TraceConfig& config, int threads = 0, const std::stop_token& stop = {});

    /// Traces the pixels of `tiles` into `frame` on `threads` threads (0 = all), in order as far as threads allow.
    /// False where stopped before the end. `progress` receives the fraction done and may be called from several
    /// threads.
    bool trace_tiles(const TraceConfig& config, const PinholeCamera& camera, std::span<const Tile> tiles, Frame& frame,
                     int threads = 0, std::stop_token stop = {}, const std::function<void(float)>& progress = {});

    /// All tiles of the frame.
    bool trace_frame(const TraceConfig& config, const PinholeCamera& camera, Frame& frame, int threads = 0,
                     std::stop_token stop = {}, const std::function<void(float)>& progress = {});

    /// Traces the rays given. `counters` may be empty (nothing is counted then) or as long as `rays`. False where
    /// stopped before the end.
    bool trace_rays(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
                    std::span<RayCounters> counters, int threads = 0, std::stop_token stop = {});

    /// Bytes of the tables that the last call made or kept.
    [[nodiscard]] std::int64_t table_bytes() const;

  private:
    std::unique_ptr<SceneView> view_;
};

/// The same, known before: bytes of the tables that `needs` asks for in a trace by `in_force`. The blocks of leaves,
/// for which no need asks, come on top.
[[nodiscard]] std::int64_t cpu_table_bytes(const KdTree& tree, const SceneNeeds& needs,
                                           CpuMode in_force = CpuMode::scalar);

/// Instruction set that the hot code runs with, chosen when first used ("AVX-512", "AVX2", "SSE4", ...).
[[nodiscard]] std::string cpu_target_name();

}  // namespace kd
