#include "renderer/measure/frame_walks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <utility>

#include "renderer/geometry/order_statistics.h"

namespace kd {

namespace {

/// Calls visit(x, y) for the upper left corner of every tile of the block.
template <class Visit>
void for_each_tile(const Tile& area, int tile_width, int tile_height, const Visit& visit) {
    for (int y = area.y0; y < area.y1; y += tile_height)
        for (int x = area.x0; x < area.x1; x += tile_width) visit(x, y);
}

int distinct(std::vector<int>& values) {
    std::ranges::sort(values);
    return int(values.size() - std::ranges::unique(values).size());
}

float overhead_of(const PixelWalks& pixel) {
    if (!pixel.same_hit) return std::numeric_limits<float>::infinity();
    if (pixel.stack_interior == 0) return std::numeric_limits<float>::quiet_NaN();
    return float(double(pixel.interior_steps()) / double(pixel.stack_interior));
}

/// Sums over pixels that several blocks add to.
struct Overhead {
    std::uint64_t walked = 0, with_stack = 0;
    std::int64_t unlike = 0;

    void add(const PixelWalks& pixel) {
        walked += pixel.interior_steps();
        with_stack += pixel.stack_interior;
        unlike += !pixel.same_hit;
    }
    void add(const Overhead& more) {
        walked += more.walked;
        with_stack += more.with_stack;
        unlike += more.unlike;
    }
    [[nodiscard]] double whole() const { return with_stack > 0 ? double(walked) / double(with_stack) : 0; }
};

/// Where the primary rays of a configuration begin.
std::string entry_name(const TraceConfig& config, Pass rays) {
    if (rays == Pass::rt_prim && enters_by_tile(config)) return fmt::format("{0}×{0} px tiles", config.entry_tile);
    if (rays == Pass::rt_prim && enters_by_eye(config)) return "the eye's leaf";
    return "the root";
}

int depth_of(const KdTree& tree, int node) {
    int depth = 0;
    for (; node > 0; node = tree.nodes[std::size_t(node)].parent) ++depth;
    return depth;
}

/// Sums over pixels of what beginning below the root saves.
struct Savings {
    std::int64_t from_root = 0, saved = 0;

    void add(const Savings& more) {
        from_root += more.from_root;
        saved += more.saved;
    }
    [[nodiscard]] double share() const { return from_root > 0 ? double(saved) / double(from_root) : 0; }
};

/// Some whole tiles, so that a block is worth a task of its own.
int block_side(int tile) { return tile * std::max(1, 32 / tile); }

void fill_groups(const BlockWalks& block, int node_bytes, LockstepLayer& layer) {
    for_each_tile(block.area, layer.tile_width, layer.tile_height, [&](int x, int y) {
        const auto lanes = lanes_of(block, x, y, layer.tile_width, layer.tile_height);
        LockstepGroup& group = layer.group_at(x, y);
        group.tally = run_group(lanes, layer.schedule);
        group.reads = read_nodes(lanes, layer.schedule, node_bytes);
        count_hits(lanes, group);
    });
}

/// What measure_divergence() collects while blocks come in.
class Collector {
  public:
    Collector(std::span<const TileShape> tiles, int node_bytes)
        : tiles_(tiles), node_bytes_(node_bytes), shapes_(tiles.size()) {}

    void add(const BlockWalks& block) {
        std::vector<Shape> shapes(tiles_.size());
        for (std::size_t i = 0; i < tiles_.size(); ++i)
            for_each_tile(block.area, tiles_[i].width, tiles_[i].height, [&](int x, int y) {
                add_group(lanes_of(block, x, y, tiles_[i].width, tiles_[i].height), shapes[i]);
            });
        const std::scoped_lock lock(mutex_);
        for (std::size_t i = 0; i < tiles_.size(); ++i) shapes_[i].add(shapes[i]);
        for (const PixelWalks& pixel : block.pixels) {
            if (pixel.rays.empty()) continue;
            ++pixels_;
            steps_ += pixel.steps();
            overhead_.add(pixel);
            if (pixel.stack_interior > 0) overheads_.push_back(overhead_of(pixel));
        }
    }

    [[nodiscard]] DivergenceReport report() {
        DivergenceReport report;
        report.pixels = pixels_;
        report.steps = steps_;
        report.overhead = overhead_.whole();
        report.unlike_hits = overhead_.unlike;
        if (!overheads_.empty()) report.median_overhead = double(percentile(overheads_, 0.5));
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            DivergencePoint point;
            point.tile_width = tiles_[i].width;
            point.tile_height = tiles_[i].height;
            for (std::size_t s = 0; s < schedule_count; ++s)
                point.by_schedule[s] = summarise_efficiency(shapes_[i].tallies[s], point.lanes());
            point.reads = shapes_[i].reads;
            point.hits = correlate_hits(shapes_[i].groups, point.lanes());
            report.points.push_back(point);
        }
        return report;
    }

  private:
    struct Shape {
        std::array<std::vector<GroupTally>, schedule_count> tallies;
        std::vector<LockstepGroup> groups;  // under while-while
        NodeReads reads;

        void add(const Shape& more) {
            for (std::size_t s = 0; s < schedule_count; ++s)
                tallies[s].insert(tallies[s].end(), more.tallies[s].begin(), more.tallies[s].end());
            groups.insert(groups.end(), more.groups.begin(), more.groups.end());
            reads += more.reads;
        }
    };

    void add_group(std::span<const PixelWalks* const> lanes, Shape& shape) const {
        for (std::size_t s = 0; s < schedule_count; ++s)
            shape.tallies[s].push_back(run_group(lanes, static_cast<Schedule>(s)));
        LockstepGroup group;
        group.tally = shape.tallies[std::size_t(Schedule::while_while)].back();
        count_hits(lanes, group);
        shape.groups.push_back(group);
        shape.reads += read_nodes(lanes, Schedule::while_while, node_bytes_);
    }

    std::span<const TileShape> tiles_;
    int node_bytes_;
    std::mutex mutex_;
    std::vector<Shape> shapes_;
    std::int64_t pixels_ = 0;
    std::uint64_t steps_ = 0;
    Overhead overhead_;
    std::vector<float> overheads_;
};

}  // namespace

std::vector<const PixelWalks*> lanes_of(const BlockWalks& block, int x, int y, int tile_width, int tile_height) {
    std::vector<const PixelWalks*> lanes;
    lanes.reserve(std::size_t(tile_width) * std::size_t(tile_height));
    for (int row = y; row < y + tile_height; ++row)
        for (int column = x; column < x + tile_width; ++column)
            lanes.push_back(row < block.area.y1 && column < block.area.x1 ? &block.at(column, row) : nullptr);
    return lanes;
}

void count_hits(std::span<const PixelWalks* const> lanes, LockstepGroup& group) {
    std::vector<int> triangles, leaves;
    for (const PixelWalks* lane : lanes) {
        if (!lane || lane->rays.empty()) continue;
        ++group.rays;
        if (lane->hit_triangle >= 0) triangles.push_back(lane->hit_triangle);
        if (lane->hit_leaf >= 0) leaves.push_back(lane->hit_leaf);
    }
    group.triangles = distinct(triangles);
    group.leaves = distinct(leaves);
}

std::optional<LockstepLayer> walk_frame(WalkRequest request, Schedule schedule, int tile_width, int tile_height,
                                        std::stop_token stop, const std::function<void(float)>& progress) {
    LockstepLayer layer(request.rays, schedule, tile_width, tile_height, request.width, request.height);
    request.block_width = block_side(tile_width);
    request.block_height = block_side(tile_height);
    request.with_stack = request.from_root = true;
    layer.entry = entry_name(request.config, request.rays);
    const int node_bytes = bytes_of(nodes_in_force(request.config));
    std::mutex mutex;
    Overhead all;
    Savings all_saved;
    // Blocks are made of whole groups, and so no two threads write to one place.
    const auto fill = [&](const BlockWalks& block) {
        fill_groups(block, node_bytes, layer);
        Overhead own;
        Savings own_saved;
        std::size_t i = 0;
        for (int y = block.area.y0; y < block.area.y1; ++y)
            for (int x = block.area.x0; x < block.area.x1; ++x, ++i) {
                const PixelWalks& pixel = block.pixels[i];
                if (pixel.rays.empty()) continue;
                own.add(pixel);
                layer.steps.at(x, y) = std::int64_t(pixel.steps());
                layer.overhead.at(x, y) = overhead_of(pixel);
                layer.entry_depth.at(x, y) = float(depth_of(request.tree, pixel.entry_node));
                const std::int64_t saved = std::int64_t(pixel.root_steps) - std::int64_t(pixel.steps());
                layer.steps_saved.at(x, y) = float(saved);
                own_saved.add({std::int64_t(pixel.root_steps), saved});
            }
        const std::scoped_lock lock(mutex);
        all.add(own);
        all_saved.add(own_saved);
    };
    if (!record_walks(request, fill, std::move(stop), progress)) return std::nullopt;
    layer.unlike_hits = all.unlike;
    layer.whole_overhead = all.whole();
    layer.share_saved = all_saved.share();
    return layer;
}

std::span<const TileShape> width_curve() {
    static constexpr std::array<TileShape, 7> shapes{{{2, 2}, {4, 2}, {4, 4}, {8, 4}, {8, 8}, {16, 16}, {32, 32}}};
    return shapes;
}

std::optional<DivergenceReport> measure_divergence(WalkRequest request, std::span<const TileShape> tiles,
                                                   std::stop_token stop, const std::function<void(float)>& progress) {
    request.block_width = block_side(tiles.back().width);
    request.block_height = block_side(tiles.back().height);
    request.with_stack = true;
    Collector collector(tiles, bytes_of(nodes_in_force(request.config)));
    const auto add = [&](const BlockWalks& block) { collector.add(block); };
    if (!record_walks(request, add, std::move(stop), progress)) return std::nullopt;
    DivergenceReport report = collector.report();
    report.rays = request.rays;
    report.traversal = request.config.traversal;
    return report;
}

}  // namespace kd
