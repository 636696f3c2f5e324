// A tree for triangles that have moved, from an earlier one.
#pragma once

#include <optional>
#include <string>

#include "renderer/kdtree/build.h"

namespace kd {

struct RefitConfig {
    /// A tree that would hold more than this many times the references of the earlier one is not made: the planes no
    /// longer suit the triangles. At least 1.
    float most_growth = 1.5f;
};

struct RefitReport {
    double seconds = 0;    // by the wall clock
    std::string why_none;  // a part of a sentence; empty where there is a tree
};

/// Keeps the planes of `earlier`, a tree of as many triangles, and sorts the triangles into its cells anew. Bounds are
/// the triangles' own. A plane outside of its cell, as the bounds have shrunk, goes with what lies behind it; cells
/// with BuildConfig::leaf_size triangles and fewer become leaves. No leaf is split any further. Costs, leaves and depth
/// are those of `build`, which should be what `earlier` was built with; what chooses planes there is not used.
/// Nothing where the number of triangles has changed or the tree would grow too much; then it has to be built.
/// A stop request ends it early with a valid tree. The tree is the same for any number of `threads` (0 = all).
/// InputError as build_tree().
[[nodiscard]] std::optional<KdTree> refit_tree(const KdTree& earlier, std::size_t earlier_triangles,
                                               std::span<const Triangle> triangles, const BuildConfig& build,
                                               const RefitConfig& config = {}, RefitReport* report = nullptr,
                                               std::stop_token stop = {}, int threads = 0);

}  // namespace kd
