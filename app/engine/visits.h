// Visits of each node by the rays of the picture, counted behind the window while something shows them.
#pragma once

#include <memory>
#include <string>

#include "app/engine/background.h"
#include "app/engine/world.h"
#include "renderer/measure/node_visits.h"

namespace kd {

struct VisitState {
    bool active = false;
    bool outdated = true;  // the visits are of another frame or other rays than those shown
    float fraction = 0;    // 0..1
    Pass rays = Pass::rt_prim;
    std::shared_ptr<const NodeVisits> visits;  // of `rays`; null until counted
    std::shared_ptr<const World> world;        // whose nodes these are
    std::string error;                         // why there are none
};

}  // namespace kd
