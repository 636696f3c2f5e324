// The list of procedural scenes. A new scene is a file of its own, scene_NAME.cpp, that defines kd::NAME_scene(), and
// one line here.
#pragma once

#include "renderer/scene/procedural.h"

#define KD_PROCEDURAL_SCENES(SCENE)                                                                                    \
    SCENE(ball)                                                                                                        \
    SCENE(icoball)                                                                                                     \
    SCENE(rooms)                                                                                                       \
    SCENE(scatter)                                                                                                     \
    SCENE(sheet)                                                                                                       \
    SCENE(cornell)                                                                                                     \
    SCENE(topiary)

namespace kd {

#define KD_DECLARE_SCENE(name) ProceduralScene name##_scene();
KD_PROCEDURAL_SCENES(KD_DECLARE_SCENE)
#undef KD_DECLARE_SCENE

}  // namespace kd
