// A scene with the tree that was built for it: what tracing needs, never changed once made.
#pragma once

#include <memory>
#include <string>

#include "app/session.h"
#include "renderer/kdtree/build.h"
#include "renderer/kdtree/stats.h"
#include "renderer/measure/motion/frame_pipeline.h"
#include "renderer/scene/moving_scene.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/scene.h"

namespace kd {

/// A loaded scene and the words that asked for it.
struct LoadedScene {
    std::string name;  // Session::scene
    unsigned seed = 1;
    FlatScene flat;
    double time = 0.0;                                    // Session::time
    std::shared_ptr<const MovingScene> moving = nullptr;  // at any time; null where nothing moves
};

/// Whether it is the scene of `session`, at its time: any where nothing moves.
[[nodiscard]] inline bool asks_for(const Session& session, const LoadedScene& scene) {
    return session.scene == scene.name && session.seed == scene.seed && (!scene.moving || session.time == scene.time);
}

/// Whether two are one scene, at whatever times.
[[nodiscard]] inline bool same_scene(const LoadedScene& a, const LoadedScene& b) {
    return &a == &b || (a.moving && a.moving == b.moving);
}

struct World {
    std::shared_ptr<const LoadedScene> loaded;
    BuildConfig built_with;
    KdTree tree;
    BuildReport report;
    TreeStats stats;
    SceneFacts facts;
    bool refitted = false;  // the tree has the planes of the one at time 0
    FrameSteps steps;       // update and build by the steady clock, where it is a pose that was made beside others

    [[nodiscard]] const FlatScene& scene() const { return loaded->flat; }
};

/// Whether frames of both take much the same time: poses of one scene, with trees made by the same constants.
[[nodiscard]] inline bool alike(const World& a, const World& b) {
    return same_scene(*a.loaded, *b.loaded) && a.built_with == b.built_with;
}

}  // namespace kd
