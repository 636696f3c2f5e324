// A scene with the tree that was built for it: what tracing needs, never changed once made.
#pragma once

#include <memory>
#include <string>

#include "app/session.h"
#include "renderer/kdtree/build.h"
#include "renderer/kdtree/stats.h"
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

struct World {
    std::shared_ptr<const LoadedScene> loaded;
    BuildConfig built_with;
    KdTree tree;
    BuildReport report;
    TreeStats stats;
    SceneFacts facts;

    [[nodiscard]] const FlatScene& scene() const { return loaded->flat; }
};

}  // namespace kd
