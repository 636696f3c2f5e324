#include "renderer/measure/node_visits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "renderer/cpu/threads.h"
#include "renderer/cpu/tile_job.h"
#include "renderer/measure/error_time/lines.h"
#include "renderer/measure/error_time/ranking.h"
#include "renderer/trace/observer.h"

namespace kd {

namespace {

#include "renderer/cpu/kernel.h"
// After kernel.h, whose class it drives.
#include "renderer/cpu/pixel.h"

/// Counts visits where it is given a table that no other thread writes to. Every walk ends with one exit.
class VisitObserver : public NullObserver {
  public:
    NodeVisits* into = nullptr;

    void on_interior(int node, bool) { visit(node); }
    void on_leaf(int node) { visit(node); }
    void on_exit(int) {
        if (std::exchange(visited_, false)) ++into->rays;
    }

  private:
    void visit(int node) {
        if (!into) return;
        visited_ = true;
        ++into->count[std::size_t(node)];
    }

    bool visited_ = false;
};

/// As many tables as threads are at work at a time, summed in the end: one table for all would be fought over.
class VisitTables {
  public:
    explicit VisitTables(std::size_t nodes) : nodes_(nodes) {}

    [[nodiscard]] NodeVisits take() {
        const std::scoped_lock lock(mutex_);
        if (idle_.empty()) return {.count = std::vector<std::uint64_t>(nodes_)};
        NodeVisits table = std::move(idle_.back());
        idle_.pop_back();
        return table;
    }

    void give_back(NodeVisits table) {
        const std::scoped_lock lock(mutex_);
        idle_.push_back(std::move(table));
    }

    /// Once all are back.
    [[nodiscard]] NodeVisits sum() {
        NodeVisits all = take();
        for (const NodeVisits& table : idle_) {
            all.rays += table.rays;
            for (std::size_t i = 0; i < nodes_; ++i) all.count[i] += table.count[i];
        }
        return all;
    }

  private:
    std::size_t nodes_;
    std::mutex mutex_;
    std::vector<NodeVisits> idle_;
};

/// Work in `parts` that count into tables. Nothing where stopped.
std::optional<NodeVisits> count_parts(std::size_t nodes, std::size_t parts, int threads, const std::stop_token& stop,
                                      const std::function<void(float)>& progress,
                                      const std::function<void(std::size_t part, NodeVisits& into)>& count) {
    VisitTables tables(nodes);
    std::atomic<std::size_t> done = 0;
    parallel_ranges(parts, 1, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t part = first; part < last && !stop.stop_requested(); ++part) {
            NodeVisits table = tables.take();
            count(part, table);
            tables.give_back(std::move(table));
            const std::size_t finished = ++done;
            if (progress) progress(float(finished) / float(parts));
        }
    });
    return done == parts ? std::optional(tables.sum()) : std::nullopt;
}

template <Rules rules>
void walk_tile(const WalkRequest& request, const SceneView& view, Frame& none, const Tile& tile, NodeVisits& into) {
    const TileJob job{
        view,
        request.config,
        request.camera,
        tile,
        none,
        entry_points(request.tree, view.boxes, request.config,
                     {request.camera, request.width, request.height, tile.x0, tile.y0, tile.x1, tile.y1})};
    std::array<VisitObserver, pass_count> seen{};
    seen[std::size_t(request.rays)].into = &into;
    Kernel<VisitObserver, rules> kernel(view, request.config, seen[0]);
    std::array<Hit, pass_count> hits;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            walk_pixel(kernel, job, int2(x, y), int2(request.width, request.height), request.rays, seen, hits);
}

void walk_tile(const WalkRequest& request, const SceneView& view, Frame& none, const Tile& tile, NodeVisits& into) {
    switch (request.config.rules) {
        case Rules::robust: return walk_tile<Rules::robust>(request, view, none, tile, into);
        case Rules::as_published: return walk_tile<Rules::as_published>(request, view, none, tile, into);
        case Rules::first_edition: return walk_tile<Rules::first_edition>(request, view, none, tile, into);
    }
}

/// Its cells, with nothing in them to stop a ray.
KdTree without_triangles(KdTree tree) {
    for (TreeNode& node : tree.nodes)
        if (node.is_leaf()) node.count = 0;
    tree.references.clear();
    return tree;
}

/// Sums of `visits` by kind of node.
template <class Number>
VisitsPerRay per_ray(const KdTree& tree, const std::vector<Number>& visits, std::uint64_t rays) {
    VisitsPerRay sum;
    if (rays == 0) return sum;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const double of_a_ray = double(visits[i]) / double(rays);
        (node.is_leaf() ? sum.leaves : sum.interior) += of_a_ray;
        if (node.is_leaf()) sum.tests += of_a_ray * node.count;
    }
    return sum;
}

}  // namespace

std::optional<NodeVisits> count_node_visits(const WalkRequest& request, std::stop_token stop,
                                            const std::function<void(float)>& progress) {
    SceneView view(request.scene, request.tree);
    view.prepare(request.config);
    Frame none;  // nothing is drawn
    const std::vector<Tile> tiles = tiles_of(request.width, request.height, 16);
    auto visits =
        count_parts(request.tree.nodes.size(), tiles.size(), request.threads, stop, progress,
                    [&](std::size_t part, NodeVisits& into) { walk_tile(request, view, none, tiles[part], into); });
    if (visits) visits->kind = request.rays;
    return visits;
}

std::optional<NodeVisits> count_line_visits(const KdTree& tree, std::int64_t lines, unsigned seed, int threads,
                                            std::stop_token stop, const std::function<void(float)>& progress) {
    constexpr std::int64_t lines_per_part = 4096;
    const KdTree cells = without_triangles(tree);
    FlatScene empty;
    empty.bounds = tree.bounds;
    const SceneView view(empty, cells);
    const std::size_t parts = std::size_t((lines + lines_per_part - 1) / lines_per_part);
    const auto count = [&](std::size_t part, NodeVisits& into) {
        // Of its own for each part, so that it does not matter which thread comes first.
        Random random((std::uint64_t(seed) << 32) + part);
        const std::int64_t before = std::int64_t(part) * lines_per_part;
        VisitObserver seen;
        seen.into = &into;
        Kernel<VisitObserver, Rules::robust> kernel(view, TraceConfig{}, seen);
        for (const Ray& ray :
             uniform_lines(tree.bounds, std::size_t(std::min(lines - before, lines_per_part)), random)) {
            Hit hit = kernel.no_hit(ray);
            kernel.traverse(ray, false, hit);
        }
    };
    return count_parts(tree.nodes.size(), parts, threads, stop, progress, count);
}

VisitAgreement agreement(const KdTree& tree, const NodeVisits& visits) {
    const std::vector<double> predicted = visits.predicted(tree);
    VisitAgreement result;
    result.counted = per_ray(tree, visits.count, visits.rays);
    result.predicted = per_ray(tree, predicted, visits.rays);
    const auto rho_of = [&](const auto& wanted) {
        std::vector<double> x, y;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            if (wanted(tree.nodes[i])) {
                x.push_back(predicted[i]);
                y.push_back(double(visits.count[i]));
            }
        return spearman_rho(x, y);
    };
    result.rho = rho_of([](const TreeNode&) { return true; });
    result.rho_interior = rho_of([](const TreeNode& node) { return !node.is_leaf(); });
    result.rho_leaves = rho_of([](const TreeNode& node) { return node.is_leaf(); });
    return result;
}

}  // namespace kd
