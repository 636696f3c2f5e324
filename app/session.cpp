#include "app/session.h"

#include "renderer/scene/units.h"

namespace kd {

TraceConfig first_sample(const Session& session) {
    TraceConfig config = session.trace;
    const bool sampled = session.samples > 0;
    config.sampling.sample = sampled ? 0 : -1;
    config.sampling.seed = sampled ? session.seed : 0;
    return config;
}

Session in_scene_units(Session session, const FlatScene& scene) {
    if (session.camera) session.camera = to_scene_units(scene, *session.camera);
    for (HandSplit& split : session.build.by_hand) split.position = to_scene_units(scene, split.position);
    return session;
}

std::vector<HandSplit> to_internal(const FlatScene& scene, std::vector<HandSplit> splits) {
    for (HandSplit& split : splits) split.position = to_internal(scene, split.position);
    return splits;
}

}  // namespace kd
