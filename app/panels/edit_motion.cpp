// Changes that panels and keys share: the motion of the scene.
#include "app/panels/edit.h"
#include "renderer/scene/moving_scene.h"

namespace kd::edits {

void toggle_playing(const EngineState& state, Edit& edit) {
    if (state.duration() > 0)
        edit.window.motion.playing = !edit.window.motion.playing;
    else
        edit.window.bottom = motion_panel;
}

void seek(const EngineState& state, Edit& edit, double seconds) {
    edit.window.motion.playing = false;
    edit.session.time = place_in_motion(seconds, state.duration());
}

void step_motion(const EngineState& state, Edit& edit, int frames) {
    if (state.duration() > 0) seek(state, edit, edit.session.time + frames * motion_step_s);
}

void settle_motion(const EngineState& state, Edit& edit) {
    const bool still = state.world && !state.loading.active && !(state.duration() > 0);
    if (still || (state.motion.ended && !state.motion.playing)) edit.window.motion.playing = false;
}

}  // namespace kd::edits
