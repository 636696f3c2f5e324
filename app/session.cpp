#include "app/session.h"

#include "renderer/scene/units.h"

namespace kd {

Session in_scene_units(Session session, const FlatScene& scene) {
    if (session.camera) session.camera = to_scene_units(scene, *session.camera);
    return session;
}

}  // namespace kd
