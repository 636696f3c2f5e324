#include "renderer/scene/moving_scene.h"

#include <cmath>
#include <utility>

#include "renderer/scene/motion.h"

namespace kd {

MovingScene::MovingScene(Scene scene) : scene_(std::move(scene)), at_rest_(flatten(scene_)) {
    at_rest_.duration = duration();
    if (!scene_.motion) scene_ = {};  // nobody asks for it again
}

double MovingScene::duration() const { return scene_.motion ? scene_.motion->duration() : 0.0; }

FlatScene MovingScene::at(double seconds) const& {
    const double place = place_in_motion(seconds, duration());
    return place == 0.0 ? at_rest_ : posed(place);
}

FlatScene MovingScene::at(double seconds) && {
    const double place = place_in_motion(seconds, duration());
    return place == 0.0 ? std::move(at_rest_) : posed(place);
}

FlatScene MovingScene::posed(double place) const {
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
    return place > 0.0 && place < duration ? place : 0.0;  // never -0
}

}  // namespace kd
