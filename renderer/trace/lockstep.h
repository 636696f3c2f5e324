// Groups of rays in lockstep: how many iterations a machine of W lanes makes, and how many of its lanes work in them.
//
// docs/divergence.md defines the numbers (there D1 to D8). All are sums of integers, so that a machine that counts its
// own lanes must come to the very same ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/trace/schedule.h"
#include "renderer/trace/walk.h"

namespace kd {

/// What a group did.
struct GroupTally {
    std::uint64_t steps = 0;                // of all lanes
    std::uint64_t iterations = 0;           // that the group pays for, each with all its lanes
    std::uint64_t interior_iterations = 0;  // those of them that step interior nodes; 0 for Schedule::lockstep

    GroupTally& operator+=(const GroupTally& more);
    bool operator==(const GroupTally&) const = default;

    /// steps / (lanes * iterations), in [1/lanes, 1]; NaN where there was nothing to do.
    [[nodiscard]] double efficiency(int lanes) const;
};

/// What a group read of the tree: each node by all lanes that visit it in the same iteration at once.
struct NodeReads {
    std::uint64_t iterations = 0;  // in which some lane reads a node
    std::uint64_t lanes = 0;       // lanes that read one, over these iterations
    std::uint64_t nodes = 0;       // different ones
    std::uint64_t sectors = 0;     // different 32-byte sectors
    std::uint64_t lines = 0;       // different 128-byte lines

    NodeReads& operator+=(const NodeReads& more);
    bool operator==(const NodeReads&) const = default;

    /// (lanes - nodes) / (lanes - iterations): 1 where lanes that read together read one node, 0 where each reads its
    /// own. NaN where no two lanes ever read together.
    [[nodiscard]] double coherence() const;
};

/// One round: the lanes' phases as Walk::phases() tells them.
[[nodiscard]] GroupTally run_phases(std::span<const std::vector<std::uint32_t>* const> lanes, Schedule schedule);

/// A group of pixels; null and pixels without rays are idle lanes.
[[nodiscard]] GroupTally run_group(std::span<const PixelWalks* const> lanes, Schedule schedule);
/// Nodes of `node_bytes`, 16 or 8, from the start of a line on.
[[nodiscard]] NodeReads read_nodes(std::span<const PixelWalks* const> lanes, Schedule schedule, int node_bytes);

}  // namespace kd
