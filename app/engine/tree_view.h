// The tree as NODES shows it: icicle and slice, laid out and coloured behind the window when something changes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/engine/background.h"
#include "app/engine/world.h"
#include "renderer/measure/node_visits.h"
#include "viz/cell_colours.h"
#include "viz/slice.h"
#include "viz/tree_layout.h"

namespace kd {

/// How NODES shall show the tree.
struct TreeViewWish {
    IcicleWidth width = IcicleWidth::leaves;
    CellColour colour = CellColour::depth;
    std::string colormap = "viridis";
    std::string root;    // path of the node that takes the icicle's whole width
    int columns = 0;     // of pixels, that the icicle has; 0: nothing is shown
    SlicePlane slice{};  // in the units of the tree

    bool operator==(const TreeViewWish&) const = default;
};

struct TreeView {
    TreeViewWish of;
    std::shared_ptr<const World> world;
    std::shared_ptr<const NodeVisits> visits;  // null until they are counted
    int root = 0;
    std::vector<IcicleCell> icicle;
    int rows = 1;              // of the icicle
    std::vector<int> cell_of;  // by node: its index in `icicle`, or that of the nearest node above it that is wide
                               // enough to be there; -1 outside of the root's subtree
    std::vector<SliceCell> slice;
    std::vector<SliceSegment> segments;
    NodeColours colours;
    std::vector<double> predicted;  // visits by node; empty without `visits`
};

struct TreeViewState {
    bool active = false;
    std::shared_ptr<const TreeView> view;  // null until the first is there
    std::string error;                     // why there is none
};

/// All member functions are called on the thread that owns `state`.
class TreeViewBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    TreeViewBench(Mailbox& mailbox, TreeViewState& state) : state_(state), run_(mailbox) {}

    /// Lays the tree out anew where anything of this differs from what is there or on its way. `visits` of the same
    /// tree, or null.
    void follow(const TreeViewWish& wish, const std::shared_ptr<const World>& world,
                const std::shared_ptr<const NodeVisits>& visits);

  private:
    TreeViewState& state_;
    TreeViewWish wish_;
    std::weak_ptr<const World> world_;
    std::weak_ptr<const NodeVisits> visits_;
    BackgroundRun run_;  // last: joined before what its jobs use goes
};

}  // namespace kd
