#include "renderer/scene/moving_scene.h"

#include <cmath>
#include <utility>

#include "renderer/scene/motion.h"

namespace kd {

MovingScene::MovingScene(Scene scene) : scene_(std::move(scene)), at_rest_(flatten(scene_)) {
    at_rest_.duration = duration();
}

double MovingScene::duration() const { return scene_.motion ? scene_.motion->duration() : 0.0; }

FlatScene MovingScene::at(double seconds) const {
    const double place = place_in_motion(seconds, duration());
    if (place == 0.0) return at_rest_;
    Scene posed = scene_;
    scene_.motion->pose(posed, place);
    FlatScene flat = flatten_like(posed, at_rest_);
    flat.duration = duration();
    flat.time = place;
    return flat;
}

double place_in_motion(double seconds, double duration) {
    if (!(duration > 0.0)) return 0.0;
    double place = std::fmod(seconds, duration);
    if (place < 0.0) place += duration;
    return place < duration ? place : 0.0;
}

}  // namespace kd
