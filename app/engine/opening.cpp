// Session files in the engine: read at once, complete when their scene is there.

#include <utility>

#include "app/engine/engine.h"
#include "app/session_file.h"
#include "renderer/geometry/input_error.h"
#include "renderer/scene/units.h"

namespace kd {

void Engine::open_session(const std::string& file) {
    forget_refused();
    Session next;
    try {
        next = read_session(file);
    } catch (const InputError& error) {
        say(true, error.what());
        state_.refused = RefusedScene{file, error.what()};
        return;
    }
    say(false, "opened " + file);
    const Session before = opened_ ? opened_->before : state_.session;
    next.width = state_.session.width;
    next.height = state_.session.height;
    opened_.reset();
    for (const auto& loaded : {scene_, state_.world ? state_.world->loaded : nullptr}) {
        if (!loaded || loaded->name != next.scene || loaded->seed != next.seed) continue;  // at whatever time
        next.camera = usable_camera(loaded->flat, next.camera);
        next.build.by_hand = to_internal(loaded->flat, std::move(next.build.by_hand));
        return set_session(next);
    }
    OpenedSession opened{std::exchange(next.camera, std::nullopt), std::exchange(next.build.by_hand, {}), before, file};
    set_session(next);
    opened_ = std::move(opened);
}

/// The wish that came to nothing, and what was said about it: there is another one now.
void Engine::forget_refused() {
    if (state_.refused) std::erase_if(state_.messages, [&](const Message& m) { return m.text == state_.refused->why; });
    state_.refused.reset();
}

/// A camera in the scene's units as the scene has it; none, and a message, where nothing can be seen by it.
std::optional<Camera> Engine::usable_camera(const FlatScene& scene, const std::optional<Camera>& asked) {
    if (!asked) return std::nullopt;
    const Camera camera = to_internal(scene, *asked);
    if (is_valid(camera)) return camera;
    say(true, "camera: its values cannot be used with this scene; the scene's own is shown");
    return std::nullopt;
}

void Engine::take_opened_lengths(const FlatScene& scene) {
    if (!opened_) return;
    state_.session.camera = usable_camera(scene, opened_->camera);
    state_.session.build.by_hand = to_internal(scene, std::move(opened_->by_hand));
    opened_.reset();
}

}  // namespace kd
