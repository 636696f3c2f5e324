// Building: one configuration, one table of builders, each a free function from triangles to a tree.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/kdtree/hand_split.h"
#include "renderer/kdtree/tree.h"

namespace kd {

/// Least and most of BuildConfig::bins.
inline constexpr int fewest_bins = 4;
inline constexpr int most_bins = 256;

/// Constants of the builders. Costs are in units of one traversal step unless said otherwise.
struct BuildConfig {
    std::string builder = "paper";
    /// Cost t_t of visiting an interior node.
    float traversal_cost = 1.0f;
    /// Cost t_i of one triangle test. Larger makes deeper trees with fewer tests.
    float intersection_cost = 1.5f;
    /// b_e, 0..1: the fraction of the intersection cost forgiven when one child is empty. Larger carves off more space.
    float empty_bonus = 0.2f;
    /// The bonus is given only where the empty child is at least this fraction of the node's extent along the axis.
    float empty_bonus_gate = 0.1f;
    /// Where at least this fraction of a cell, from one face on, holds no triangle, it is cut off before anything else
    /// is tried (Zhou, Hou, Wang, Guo 2008); 0 = never.
    float empty_cut = 0.0f;
    /// Nodes with at most this many triangles become leaves.
    int leaf_size = 2;
    /// Triangles that a tracer tests at once, 1 to 16: t_i is paid for each so many of a leaf, the last ones included
    /// (8 for trees that CpuMode::wide walks).
    int leaf_block = 1;
    /// 0 = 8 + 1.6 log2(N); never above max_tree_depth.
    int max_depth = 0;
    /// How often on one path a split may cost more than it saves before the node becomes a leaf (pbrt: 2).
    int bad_refines = 0;
    /// The tree never holds more references than this many per triangle. Where it would, children share their parent's
    /// allowance in proportion to their triangles (see grow.h), so that nothing starves; a split that needs more is not
    /// made, told in BuildReport::reference_cap_hit.
    float reference_cap = 64.0f;
    /// Planes that the builder with bins looks at: one between every two of so many bins on each axis.
    int bins = 32;
    /// A leaf names only triangles whose surface reaches its cell, not all whose bounding box does (the paper's
    /// choice): the same splits with a quarter fewer triangle tests.
    bool trim_leaves = true;
    /// Planes put by a person, in any order, one for a path at most.
    std::vector<HandSplit> by_hand{};

    bool operator==(const BuildConfig&) const = default;
};

/// Where the time of a build went, in seconds added over its threads, small cells by sample (renderer/kdtree/phases.h).
/// What is missing from BuildReport::seconds times threads is checks, bookkeeping and threads that wait.
struct BuildPhases {
    double prepare = 0;  // projections of the triangles, sorted where the builder sorts
    double choose = 0;   // looking for the planes
    double divide = 0;   // lists of both sides, with clipping where the builder clips
    double leaves = 0;   // lists of leaves, trimmed

    [[nodiscard]] double sum() const { return prepare + choose + divide + leaves; }
    void add(const BuildPhases& other) {
        prepare += other.prepare;
        choose += other.choose;
        divide += other.divide;
        leaves += other.leaves;
    }
    void scale(double factor) {
        prepare *= factor;
        choose *= factor;
        divide *= factor;
        leaves *= factor;
    }
};

/// What happened during a build.
struct BuildReport {
    double seconds = 0;  // by the wall clock
    BuildPhases phases;
    bool reference_cap_hit = false;
    bool depth_limit_hit = false;
    bool tests_cost_nothing = false;       // so that the tree is a single leaf, though it might be split
    int hand_splits = 0;                   // of BuildConfig::by_hand
    int idle_hand_splits = 0;              // of these, those that stand nowhere in the tree
    std::vector<std::string> idle_planes;  // a line for each of those: where, and why_idle()
};

/// How whoever has a tree built says that the cap was reached.
inline constexpr std::string_view reference_cap_note =
    "the limit of references per triangle was reached; some splits were not made";

/// What whoever has a tree built tells people of it, a line each.
[[nodiscard]] std::vector<std::string> build_notes(const BuildReport& report);

/// Called now and then with the fraction done, 0..1, from any thread of the build, one call at a time.
using BuildProgress = std::function<void(float)>;

/// What build_tree() hands to a builder, already checked: constants in range, triangles finite.
struct BuildTask {
    std::span<const Triangle> triangles;
    const BuildConfig& config;
    BuildReport& report;
    const BuildProgress& progress;  // may be empty
    std::stop_token stop;
    int threads = 0;  // 0 = all
};

class Splitter;         // renderer/kdtree/splitter.h
struct TriangleRanges;  // renderer/kdtree/cell_lists.h

struct Builder {
    std::string_view name;     // "paper"
    std::string_view title;    // "SAH as in the paper"
    std::string_view summary;  // one sentence
    std::unique_ptr<Splitter> (*splitter)(const BuildTask&, const TriangleRanges&);
    bool has_bins = false;  // BuildConfig::bins matters
};

[[nodiscard]] std::span<const Builder> builders();
[[nodiscard]] const Builder* find_builder(std::string_view name);

/// InputError for a constant out of range, for too many triangles or one that is not finite.
void check_build_input(std::span<const Triangle> triangles, const BuildConfig& config);

/// Builds with the builder that `config` names; InputError for an unknown name, a constant out of range or a triangle
/// that is not finite.
/// A stop request ends the build early with a valid tree whose unfinished nodes are leaves. Uses `threads` threads
/// (0 = all); the tree is the same for any number.
[[nodiscard]] KdTree build_tree(std::span<const Triangle> triangles, const BuildConfig& config,
                                BuildReport* report = nullptr, const BuildProgress& progress = {},
                                std::stop_token stop = {}, int threads = 0);

/// Depth limit that a config means for n triangles.
[[nodiscard]] int depth_limit(const BuildConfig& config, std::size_t n);

}  // namespace kd
