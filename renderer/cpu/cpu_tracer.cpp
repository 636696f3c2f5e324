#include "renderer/cpu/cpu_tracer.h"

#include <atomic>
#include <string_view>

#include "renderer/cpu/targets.h"
// After targets.h.
#include <hwy/highway.h>

#include "renderer/cpu/scene_view.h"
#include "renderer/cpu/threads.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/kdtree/ropes.h"

namespace kd {

namespace {

constexpr int tile_size = 16;
// Between looks at the stop request; rays of the naive traversal take as long as there are triangles.
constexpr std::size_t rays_per_task = 1024, naive_rays_per_task = 16;

void run_job(const TileJob& job) { job.view.in_force == CpuMode::scalar ? run_tile_job(job) : run_wide_tile_job(job); }

void run_job(const RayJob& job) { job.view.in_force == CpuMode::scalar ? run_ray_job(job) : run_wide_ray_job(job); }

}  // namespace

std::string cpu_target_name() {
    // The best of the instruction sets that the hot code was compiled for and this processor has.
    const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
    std::string name = hwy::TargetName(usable & -usable);
    constexpr std::string_view ours = "AVX3";  // Highway's word for AVX-512
    if (name.starts_with(ours)) name.replace(0, ours.size(), "AVX-512");
    return name;
}

CpuTracer::CpuTracer(const FlatScene& scene, const KdTree& tree, CpuMode mode)
    : view_(std::make_unique<SceneView>(scene, tree, mode)) {}

CpuTracer::~CpuTracer() = default;
CpuTracer::CpuTracer(CpuTracer&&) noexcept = default;

bool CpuTracer::prepare(const TraceConfig& config, int threads, const std::stop_token& stop) {
    return view_->prepare(config, threads, stop);
}

std::int64_t CpuTracer::table_bytes() const {
    const auto bytes = [](const auto&... table) { return (std::span(table).size_bytes() + ...); };
    return std::int64_t(bytes(view_->packed_nodes, view_->boxes, view_->ropes, view_->duplicated_corners,
                              view_->leaf_blocks, view_->over_blocks.nodes));
}

std::int64_t cpu_table_bytes(const KdTree& tree, const SceneNeeds& needs, CpuMode in_force) {
    constexpr std::size_t ropes = faces_of_a_cell * sizeof(std::int32_t);
    const bool in_blocks = in_force != CpuMode::scalar;
    const std::size_t own_nodes = in_blocks ? sizeof(TreeNode) : 0;  // else those of the tree
    const std::size_t of_a_node = (needs.wide_nodes ? own_nodes : sizeof(PackedNode)) +
                                  (needs.node_boxes ? sizeof(Aabb) : 0) + (needs.ropes ? ropes : 0);
    return std::int64_t(tree.nodes.size() * of_a_node +
                        (needs.leaf_copies && !in_blocks ? tree.references.size() * sizeof(Triangle) : 0));
}

bool CpuTracer::trace_tiles(const TraceConfig& config, const PinholeCamera& camera, std::span<const Tile> tiles,
                            Frame& frame, int threads, std::stop_token stop,
                            const std::function<void(float)>& progress) {
    if (!prepare(config, threads, stop)) return false;
    frame.exponent = view_->scene->exponent;
    frame.sampling = config.sampling;
    frame.hold_indirect(view_->needs.indirect);
    std::atomic<std::size_t> done = 0;
    parallel_ranges(tiles.size(), 1, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last && !stop.stop_requested(); ++i) {
            const Tile& t = tiles[i];
            const SeenArea area{camera, frame.width, frame.height, t.x0, t.y0, t.x1, t.y1};
            run_job({*view_, config, camera, t, frame, entry_points(*view_->tree, view_->boxes, config, area)});
            const std::size_t finished = ++done;
            if (progress) progress(float(finished) / float(tiles.size()));
        }
    });
    return done == tiles.size();
}

bool CpuTracer::trace_frame(const TraceConfig& config, const PinholeCamera& camera, Frame& frame, int threads,
                            std::stop_token stop, const std::function<void(float)>& progress) {
    return trace_tiles(config, camera, tiles_of(frame.width, frame.height, tile_size), frame, threads, stop, progress);
}

bool CpuTracer::trace_rays(const TraceConfig& config, std::span<const Ray> rays, bool any_hit, std::span<Hit> hits,
                           std::span<RayCounters> counters, int threads, std::stop_token stop) {
    if (!prepare(config, threads, stop)) return false;
    const std::size_t grain = config.traversal == Traversal::naive ? naive_rays_per_task : rays_per_task;
    std::atomic<std::size_t> done = 0;
    parallel_ranges(rays.size(), grain, threads, [&](std::size_t first, std::size_t last) {
        if (stop.stop_requested()) return;
        const std::size_t n = last - first;
        run_job({*view_, config, rays.subspan(first, n), any_hit, hits.subspan(first, n),
                 counters.empty() ? counters : counters.subspan(first, n)});
        done += n;
    });
    return done == rays.size();
}

}  // namespace kd
