// The picture with what lies over it, and the mouse on it.
#pragma once

#include "app/panels/edit.h"
#include "app/window/layout.h"
#include "app/window/picture_texture.h"
#include "app/window/plane_grip.h"

namespace kd {

class Viewport {
  public:
    explicit Viewport(const GlApi& gl) : image_(gl) {}

    /// Draws the newest picture into `area` and turns what the mouse does there into edits: the picture's size, the
    /// camera, the pixel under the mouse, the pinned one. `seconds` since the frame before, for flying.
    void draw(const Rectangle& area, const EngineState& state, double now, float seconds, Edit& edit);

    /// A button is held over the picture that lets letters fly: they are no commands then.
    [[nodiscard]] bool flying() const { return flying_; }

  private:
    void update_texture(const EngineState& state);
    void handle_mouse(const Rectangle& area, const EngineState& state, Edit& edit);
    void handle_drag(const Rectangle& area, const EngineState& state, Edit& edit);
    void handle_click(const EngineState& state, Edit& edit);
    void handle_flight(const EngineState& state, float seconds, Edit& edit);

    PictureTexture image_;
    std::shared_ptr<const Picture> uploaded_;
    bool flying_ = false;
    float dragged_ = 0;  // pixels since the button went down
    std::optional<PixelPosition> pinned_before_click_;
    std::optional<std::string> node_before_click_;
    PlaneGrip grip_;
    double stale_since_ = -1;
};

/// Crosshair of the pinned pixel and the cells along its ray. `scale` is window pixels per picture pixel.
void draw_marks(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit, ImVec2 scale);

/// What the colours of the picture mean, in a corner of it that people can drag it out of.
void draw_legend(const Rectangle& area, const Picture& picture, Corner& corner);

/// How many pixels have no answer, as a button that leads to the map of reasons; nothing where all have one. In the
/// picture's top left corner, or the other one where the legend lies there.
void draw_unfinished(const Rectangle& area, const EngineState& state, Edit& edit);

/// Remarks of the last seconds, in the picture's top left corner, below that button.
void draw_messages(ImDrawList& list, const Rectangle& area, const EngineState& state, const Edit& edit, double now);

}  // namespace kd
