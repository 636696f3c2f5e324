// Growing the subtree of one cell, on one thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/kdtree/growers_share.h"
#include "renderer/kdtree/phases.h"
#include "renderer/kdtree/plane_chooser.h"
#include "renderer/kdtree/splitter.h"

namespace kd {

/// A cell that waits to become a node.
struct Pending {
    Aabb cell;
    int parent = -1;
    bool is_above = false;
    NodePath path{};
    int bad_refines = 0;
    std::int64_t allowance = 0;  // references that its leaves may hold together
    double work = 1.0;           // its share of the whole build
};

/// A cell with all that its subtree grows from.
struct Seed {
    Pending at;
    CellLists lists;
    std::unique_ptr<Splitter> splitter;
};

/// Depth first by a work list, never by recursion; used once.
class Grower {
  public:
    Grower(const BuildTask& task, GrowersShare& shared, Seed seed);
    ~Grower() { give_room_back(); }
    Grower(const Grower&) = delete;
    Grower& operator=(const Grower&) = delete;

    /// The whole subtree, its links counted from its first node and reference.
    [[nodiscard]] KdTree grow();

    /// One split: the plane, and what the cells below and above it grow from.
    struct Halves {
        Split split;
        Seed below, above;
    };
    /// Nothing where grow() makes a leaf: then the seed is rest().
    [[nodiscard]] std::optional<Halves> halve();
    [[nodiscard]] Seed rest();

    /// Of what was done so far.
    [[nodiscard]] const BuildReport& report() const { return report_; }

  private:
    void give_room_back();
    void begin_cell() { clock_.begin_cell(lists_.top().size()); }
    [[nodiscard]] Seed top_alone(const Pending& at) const { return {at, lists_.top_alone(), splitter_->top_alone()}; }
    int add_node(const Pending& at);
    std::optional<Split> choose(const Pending& at);
    std::optional<Split> allowed(const Pending& at);
    void divide(const Pending& at, const Split& split);
    [[nodiscard]] static Pending take_below(Pending& at, const Split& split, int node);
    void make_leaf();

    const BuildTask& task_;
    GrowersShare& shared_;
    CellLists lists_;
    std::unique_ptr<Splitter> splitter_;
    PlaneChooser chooser_;
    int depth_limit_;
    KdTree tree_;
    std::vector<Pending> pending_;
    BuildReport report_;
    PhaseClock clock_;
    double untold_ = 0.0;       // work done since SharedProgress was told last
    std::int64_t unspent_ = 0;  // references that the budget does not know of
};

}  // namespace kd
