// A scene with the tree that was built for it: what tracing needs, never changed once made.
#pragma once

#include <memory>
#include <string>

#include "renderer/kdtree/build.h"
#include "renderer/kdtree/stats.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/scene.h"

namespace kd {

/// A loaded scene and the words that asked for it.
struct LoadedScene {
    std::string name;  // Session::scene
    unsigned seed = 1;
    FlatScene flat;
};

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
