// What rays do, step by step: what groups of them in lockstep are computed from.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace kd {

enum class StepKind : std::uint8_t { interior, leaf, triangle };

/// Steps of one kind whose addresses grow by one: nodes of the tree, or places in the leaf lists for triangles.
struct StepRun {
    std::uint32_t address = 0;  // of the first
    std::uint32_t count = 0;
    StepKind kind = StepKind::interior;

    bool operator==(const StepRun&) const = default;
};

/// One ray's way through the tree: interior visits, leaf visits and triangle tests in the order in which they came.
class Walk {
  public:
    void add(StepKind kind, std::uint32_t address);
    void append(const Walk& next);

    [[nodiscard]] const std::vector<StepRun>& runs() const { return runs_; }
    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] std::uint64_t interior_steps() const;
    /// The leaves visited, in their order, each as often as it was.
    [[nodiscard]] std::vector<int> leaves() const;
    /// Lengths of its phases, in turn: steps at interior nodes (perhaps 0), steps at leaves (visits and tests), steps
    /// at interior nodes, ...
    [[nodiscard]] std::vector<std::uint32_t> phases() const;

    bool operator==(const Walk&) const = default;

  private:
    std::vector<StepRun> runs_;
};

/// A ray of a pixel. Rays of one round run side by side: those to the first light, say, and then those to the second.
struct RayWalk {
    int round = 0;
    Walk walk;
    std::vector<std::uint32_t> phases;  // of the walk

    RayWalk(int in_round, Walk made) : round(in_round), walk(std::move(made)), phases(walk.phases()) {}
};

/// The rays that one pass traced for one pixel, by ascending round; none where it traced nothing.
struct PixelWalks {
    std::vector<RayWalk> rays;
    int hit_triangle = -1;  // of the frame's hit, -1 where nothing was hit
    int hit_leaf = -1;      // in which it was found; -1 without a tree
    /// Interior visits of the same rays with a stack, where asked for, and whether their hit is the same to the bit.
    std::uint64_t stack_interior = 0;
    bool same_hit = true;
    /// Where the primary ray's walk began, and the steps of the same walk from the root, where asked for.
    int entry_node = 0;
    std::uint64_t root_steps = 0;

    [[nodiscard]] std::uint64_t steps() const;
    [[nodiscard]] std::uint64_t interior_steps() const;
};

}  // namespace kd
