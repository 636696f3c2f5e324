// The costs of all planes of the selected cell, reckoned behind the window.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/engine/background.h"
#include "app/engine/world.h"
#include "renderer/kdtree/cost_curve.h"

namespace kd {

/// A cost curve as it can be drawn: not more points than a screen has columns.
struct ThinCurve {
    static constexpr int most_points = 2048;

    struct Point {
        float position = 0;
        double least = 0, most = 0;  // cost of the candidates that the point stands for
    };
    std::vector<Point> points;  // by ascending position
};

/// Candidates in equal parts of the way from `low` to `high`, each part one point at its cheapest; all where they are
/// few.
[[nodiscard]] ThinCurve thin(const std::vector<SplitCandidate>& curve, float low, float high,
                             int most_points = ThinCurve::most_points);

struct CellState {
    bool active = false;
    std::string path;                        // of the node that the costs are of
    std::shared_ptr<const World> world;      // whose node it is
    std::shared_ptr<const CellCosts> costs;  // null until the first are there
    std::array<ThinCurve, 3> curves;         // of costs->curves
    std::string error;                       // why there are none
};

/// All member functions are called on the thread that owns `state`.
class CellBench {
  public:
    /// Results go through `mailbox` into `state`; both must outlive this.
    CellBench(Mailbox& mailbox, CellState& state) : state_(state), run_(mailbox) {}

    /// Whether the costs, or those that are on their way, are of this node of this tree.
    [[nodiscard]] bool is_of(const std::shared_ptr<const World>& world, const std::string& path) const;
    /// Reckons them in the background; what ran before is dropped, what there is stays until they come.
    void measure(const std::shared_ptr<const World>& world, const std::string& path, int node);
    void cancel();

  private:
    CellState& state_;
    std::weak_ptr<const World> world_;  // that the costs are of, or shall be
    std::string path_;
    BackgroundRun run_;  // last: joined before what its jobs use goes
};

}  // namespace kd
