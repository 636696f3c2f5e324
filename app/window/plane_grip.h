// The split plane of the node selected over the picture, and its grip: dragged along its axis it becomes a plane by
// hand.
#pragma once

#include "app/panels/edit.h"
#include "app/window/layout.h"

namespace kd {

struct PlaneView;  // plane_grip.cpp

class PlaneGrip {
  public:
    /// What the mouse does over the picture in `area`, which is the item that Dear ImGui was given last. True while the
    /// mouse is the grip's: the camera then stays.
    bool handle(const Rectangle& area, const EngineState& state, Edit& edit);

    /// The plane, and the grip while SPLITS is shown.
    void draw(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit) const;

  private:
    bool take(const PlaneView& view);

    bool held_ = false;
    bool moved_ = false;                     // since it was taken
    double offset_ = 0;                      // of the plane from the mouse, along the axis
    float along_u_ = 0.5f, along_v_ = 0.5f;  // where on the plane's rectangle the grip that is held is, 0..1
};

}  // namespace kd
