// A scene at any time, flat.
#pragma once

#include <utility>

#include "renderer/scene/scene.h"

namespace kd {

/// Poses and flattens a scene, whether or not it moves. All times share units, and the camera where the scene has none
/// of its own, so that a picture's camera and t mean the same in each. Safe to ask from several threads at once.
class MovingScene {
  public:
    explicit MovingScene(Scene scene);
    /// Of a scene that does not move.
    explicit MovingScene(FlatScene still) : at_rest_(std::move(still)) {}

    /// Seconds until the motion begins again; 0 where nothing moves.
    [[nodiscard]] double duration() const;

    /// As flatten() made it, at time 0.
    [[nodiscard]] const FlatScene& at_rest() const { return at_rest_; }

    /// At any finite time, also before 0; the motion is repeated. Time in proportion to the scene's size.
    [[nodiscard]] FlatScene at(double seconds) const&;
    /// Without a copy of what it holds.
    [[nodiscard]] FlatScene at(double seconds) &&;

  private:
    [[nodiscard]] FlatScene posed(double place) const;

    Scene scene_;
    FlatScene at_rest_;
};

/// Where in a motion of `duration` a time lies, 0 to below it; 0 where nothing moves.
[[nodiscard]] double place_in_motion(double seconds, double duration);

}  // namespace kd
