// The motion of the scene in the engine: poses follow each other, each with its tree, while the one before is traced.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/engine/engine.h"

namespace kd {

namespace {

constexpr double quiet_s = 0.3;  // after a change of the camera, until a person no longer drags it

/// What the numbers of a run depend on.
Session run_key(Session session) {
    session.time = 0;
    session.camera.reset();
    session.view = {};
    return session;
}

}  // namespace

/// Whether the scene asked for is there and moves.
bool Engine::moves() const {
    const Session& s = state_.session;
    return scene_ && scene_->moving && scene_->name == s.scene && scene_->seed == s.seed;
}

void Engine::play(const MotionWish& wish) {
    const MotionWish before = std::exchange(motion_wish_, wish);
    if (wish.schedule != before.schedule || wish.refit != before.refit) state_.motion.recent = {};
    if (wish.refit != before.refit) {
        drop_pose();
        state_.motion.stats = {};  // the schedules are compared by one way of making trees
    }
    if (wish.playing && !before.playing) begin_playing();
    if (!wish.playing && before.playing) end_playing();
}

void Engine::begin_playing() {
    state_.motion.ended = false;
    state_.motion.recent = {};
    state_.motion.played = 0;
    if (!moves()) return;
    state_.motion.playing = true;
    stop_duel();
    drop_pose();
    const double duration = scene_->flat.duration, time = place_in_motion(state_.session.time, duration);
    sampled_time_ = motion_wish_.loop || std::nextafter(time, duration) < duration ? time : 0;
    sampled_at_ = now();
}

/// A picture that gave way to the next at once is finished: all pixels, all samples of light.
void Engine::end_playing() {
    if (!std::exchange(state_.motion.playing, false)) return;
    drop_pose();
    if (state_.tracing.active || traced_.scale != 1 || state_.session.samples > 1) start_trace();
}

/// The pose that is being made or waits: another is asked for.
void Engine::drop_pose() {
    posing_.cancel();
    next_pose_.reset();
    state_.motion.posing = false;
    if (!state_.motion.playing) return;
    sampled_time_ = state_.session.time;
    sampled_at_ = now();
}

/// Whether a person turns the camera while poses follow each other: every step is to be seen, if coarse.
bool Engine::drags() const { return now() - last_view_ < quiet_s; }

/// Whether the picture is of the pose in use, so that another may take its place. While a person drags something a
/// preview will do: all of it would never be there.
bool Engine::shows_pose() const {
    if (!state_.picture || state_.picture->traced.world != state_.world) return false;
    return drags() || !state_.motion.playing ||
           (!state_.tracing.active && !state_.judging.active && !state_.picture->sketch);
}

/// What poll() does for the motion. Poses are made one at a time: where wishes come faster, the newest counts.
void Engine::follow_motion() {
    state_.motion.posing = false;
    if (motion_wish_.playing && !state_.motion.playing && !state_.motion.ended) begin_playing();  // the scene came late
    if (!moves() || state_.loading.active || state_.building.active || !state_.world ||
        state_.world->loaded != scene_) {
        if (!moves()) state_.motion.playing = false;
        return;
    }
    if (next_pose_ && shows_pose()) take_pose();
    if (!posing_.busy() && !next_pose_) start_pose();
    state_.motion.posing = !state_.motion.playing && (posing_.busy() || next_pose_);
}

void Engine::start_pose() {
    const bool playing = state_.motion.playing;
    if (playing && motion_wish_.schedule != FrameSchedule::pipelined && !shows_pose()) return;
    const double time = playing ? time_to_pose() : state_.session.time;
    if (!playing && time == scene_->time) return;
    pose_generation_ = state_.generation;
    const Session& s = state_.session;
    posing_.start({scene_, time, s.build, motion_wish_.refit, s.threads, state_.generation},
                  [this](const Posed& posed) { finish_pose(posed); });
}

/// By the wall clock, from the pose asked for before. Without a loop the motion ends just before it would begin again.
double Engine::time_to_pose() {
    const double now = this->now(), duration = scene_->flat.duration;
    sampled_time_ += motion_wish_.speed * (now - sampled_at_);
    sampled_at_ = now;
    if (motion_wish_.loop)
        sampled_time_ = place_in_motion(sampled_time_, duration);
    else
        sampled_time_ = std::min(sampled_time_, std::nextafter(duration, 0.0));
    return sampled_time_;
}

void Engine::finish_pose(const Posed& posed) {
    if (!posed.error.empty()) {
        say(true, posed.error);
        state_.motion.playing = false;
        state_.motion.ended = true;
        Session back = state_.session;
        back.time = scene_->time;
        set_session(back);
        return;
    }
    // Another tree was asked for meanwhile.
    if (!posed.world || posed.task.build != state_.session.build || posed.task.of->moving != scene_->moving) return;
    state_.motion.made = posed.made;
    state_.motion.refused = posed.refused;
    state_.motion.why_refused = posed.why_refused;
    state_.motion.first_cost = posed.first_cost;
    next_pose_ = posed.world;
}

void Engine::take_pose() {
    use(std::exchange(next_pose_, nullptr));
    scene_ = state_.world->loaded;
    if (state_.motion.playing) {
        state_.session.time = scene_->time;
        if (!motion_wish_.loop && std::nextafter(scene_->time, scene_->flat.duration) >= scene_->flat.duration) {
            state_.motion.playing = false;
            state_.motion.ended = true;
        }
    }
    if (scene_->time == state_.session.time) {
        meantime_generation_ = 0;
        trace_generation_ = ++state_.generation;
    } else {
        meantime_generation_ = pose_generation_;
    }
    start_trace();
}

/// The steps of a frame of a motion; a finer one of the same pose takes its place.
void Engine::note_played(const TracedFrame& traced) {
    MotionState& motion = state_.motion;
    if (!motion.playing || traced.world != state_.world) return;
    if (Session key = run_key(state_.session); key != recorded_) {
        motion.recent = {};
        motion.stats = {};
        recorded_ = std::move(key);
    }
    FrameSteps steps = traced.world->steps;
    if (!(steps[FrameStep::update].end > 0)) return;  // it was there before the motion began
    steps[FrameStep::upload] = traced.upload;
    steps[FrameStep::trace] = traced.trace;
    std::vector<FrameSteps>& frames = motion.recent.frames;
    motion.recent.schedule = motion_wish_.schedule;
    if (!frames.empty() && frames.back()[FrameStep::update] == steps[FrameStep::update])
        frames.pop_back();
    else
        ++motion.played;
    frames.push_back(steps);
    if (frames.size() > MotionState::most_frames) frames.erase(frames.begin());
    const PipelineStats stats = pipeline_stats(motion.recent, 1, 1);
    if (!stats.frame_ms.empty()) motion.stats[std::size_t(motion_wish_.schedule)] = stats;
}

}  // namespace kd
