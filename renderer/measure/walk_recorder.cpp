#include "renderer/measure/walk_recorder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "renderer/cpu/threads.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/observer.h"

namespace kd {

namespace {

#include "renderer/cpu/kernel.h"
// After kernel.h, whose class it drives.
#include "renderer/cpu/pixel.h"

/// Writes down the walks of one pixel's rays. Every walk ends with one exit.
class WalkObserver : public NullObserver {
  public:
    std::vector<RayWalk> rays;
    int lights = 1;

    void on_interior(int node, bool) { walk_.add(StepKind::interior, std::uint32_t(node)); }
    void on_leaf(int node) { walk_.add(StepKind::leaf, std::uint32_t(node)); }
    void on_triangle(int slot) { walk_.add(StepKind::triangle, std::uint32_t(slot)); }
    /// The rays that follow go towards this light. Each surface asks for all of them, the first one first.
    void on_light(int index) {
        surface_ += index == 0;
        light_ = index;
    }
    void on_exit(int) {
        const int round = surface_ < 0 ? int(rays.size()) : surface_ * lights + light_;
        rays.emplace_back(round, std::exchange(walk_, {}));
    }

  private:
    Walk walk_;
    int surface_ = -1, light_ = 0;
};

/// The leaf in which a triangle was met first: with the hit that counts, for nothing nearer is found in it again.
int leaf_of_hit(const KdTree& tree, const std::vector<RayWalk>& rays, int triangle) {
    for (const RayWalk& ray : rays) {
        int leaf = -1;
        for (const StepRun& run : ray.walk.runs()) {
            if (run.kind == StepKind::leaf) leaf = int(run.address + run.count - 1);
            if (run.kind != StepKind::triangle || leaf < 0) continue;
            const auto first = tree.references.begin() + run.address;
            if (std::find(first, first + run.count, triangle) != first + run.count) return leaf;
        }
    }
    return -1;
}

/// What all blocks share.
struct Recording {
    const WalkRequest& request;
    SceneView view;
    TraceConfig with_stack;
    bool enters;  // primary rays begin elsewhere than at the root
    Frame none;   // nothing is drawn

    explicit Recording(const WalkRequest& asked)
        : request(asked), view(asked.scene, asked.tree), with_stack(asked.config),
          enters(asked.rays == Pass::rt_prim && (enters_by_tile(asked.config) || enters_by_eye(asked.config))) {
        TraceConfig by_own_nodes = asked.config;  // of the tree: the steps are the same, and no table is made
        by_own_nodes.nodes = NodeEncoding::float4;
        view.prepare(by_own_nodes);
        with_stack.traversal = Traversal::stack;
    }
};

template <Rules rules>
void record_block(Recording& recording, BlockWalks& block) {
    const WalkRequest& request = recording.request;
    const auto pass = std::size_t(request.rays);
    const int2 size(request.width, request.height);
    const TileJob job{recording.view,
                      request.config,
                      request.camera,
                      block.area,
                      recording.none,
                      entry_points(request.tree, recording.view.boxes, request.config,
                                   {request.camera, request.width, request.height, block.area.x0, block.area.y0,
                                    block.area.x1, block.area.y1})};
    // What the walks are compared with begins at the root, wherever they do: with a stack, and the same walk.
    const TileJob from_root{recording.view, request.config, request.camera, block.area, recording.none};
    WalkObserver nobody;
    Kernel<WalkObserver, rules> kernel(recording.view, request.config, nobody);
    CountingObserver uncounted;
    Kernel<CountingObserver, rules> stack_kernel(recording.view, recording.with_stack, uncounted);
    Kernel<CountingObserver, rules> root_kernel(recording.view, request.config, uncounted);
    // The counters of a pixel's rays from the root.
    const auto counted_by = [&](auto& other, int2 at, std::array<Hit, pass_count>& found) {
        std::array<CountingObserver, pass_count> counted{};
        walk_pixel(other, from_root, at, size, request.rays, counted, found);
        return counted[pass].counters;
    };
    std::array<Hit, pass_count> hits, other_hits;
    std::size_t i = 0;
    for (int y = block.area.y0; y < block.area.y1; ++y)
        for (int x = block.area.x0; x < block.area.x1; ++x, ++i) {
            std::array<WalkObserver, pass_count> seen{};
            for (WalkObserver& observer : seen) observer.lights = int(request.scene.lights.size());
            walk_pixel(kernel, job, int2(x, y), size, request.rays, seen, hits);
            PixelWalks& pixel = block.pixels[i];
            pixel.rays = std::move(seen[pass].rays);
            pixel.hit_triangle = hits[pass].triangle;
            if (pixel.hit_triangle >= 0) pixel.hit_leaf = leaf_of_hit(request.tree, pixel.rays, pixel.hit_triangle);
            if (recording.enters) pixel.entry_node = job.entries.at(x, y);
            if (request.from_root)
                pixel.root_steps =
                    recording.enters ? lane_steps(counted_by(root_kernel, int2(x, y), other_hits)) : pixel.steps();
            if (!request.with_stack) continue;
            const RayCounters c = counted_by(stack_kernel, int2(x, y), other_hits);
            pixel.stack_interior = std::uint64_t(c.interior_first) + c.interior_again;
            pixel.same_hit = bit_equal(hits[pass], other_hits[pass]);
        }
}

void record_block(Recording& recording, BlockWalks& block) {
    switch (recording.request.config.rules) {
        case Rules::robust: return record_block<Rules::robust>(recording, block);
        case Rules::as_published: return record_block<Rules::as_published>(recording, block);
        case Rules::first_edition: return record_block<Rules::first_edition>(recording, block);
    }
}

std::vector<Tile> blocks_of(const WalkRequest& request) {
    std::vector<Tile> blocks;
    for (int y = 0; y < request.height; y += request.block_height)
        for (int x = 0; x < request.width; x += request.block_width)
            blocks.push_back({x, y, std::min(x + request.block_width, request.width),
                              std::min(y + request.block_height, request.height)});
    return blocks;
}

}  // namespace

bool record_walks(const WalkRequest& request, const std::function<void(const BlockWalks&)>& consume,
                  std::stop_token stop, const std::function<void(float)>& progress) {
    Recording recording(request);
    const std::vector<Tile> blocks = blocks_of(request);
    std::atomic<std::size_t> done = 0;
    parallel_ranges(blocks.size(), 1, request.threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last && !stop.stop_requested(); ++i) {
            const Tile& area = blocks[i];
            BlockWalks block{area, {}};
            block.pixels.resize(std::size_t(area.x1 - area.x0) * std::size_t(area.y1 - area.y0));
            record_block(recording, block);
            consume(block);
            const std::size_t finished = ++done;
            if (progress) progress(float(finished) / float(blocks.size()));
        }
    });
    return done == blocks.size();
}

PixelWalks record_pixel(const WalkRequest& request, int x, int y) {
    Recording recording(request);
    BlockWalks block{{x, y, x + 1, y + 1}, std::vector<PixelWalks>(1)};
    record_block(recording, block);
    return std::move(block.pixels.front());
}

}  // namespace kd
