// Growing a tree from the root down: what all builders share.
#pragma once

#include "renderer/kdtree/splitter.h"

namespace kd {

/// Splits as `splitter` says within the limits of the task's configuration. Uses a work list, never recursion.
[[nodiscard]] KdTree grow_tree(const BuildTask& task, const TriangleRanges& ranges, Splitter& splitter);

}  // namespace kd
