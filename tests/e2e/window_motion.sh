#!/usr/bin/env bash
# MOTION: the scene is played with the key, stopped, stepped and driven by the slider; at time 0 the picture is the first one.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window cornell
press shift+m
wait_for '^bottom=MOTION$'
[[ -z $(place MOTION/play) ]] || fail "a scene that does not move can be played"
press space
wait_for '^motion.playing=false$'

choose "top/scene" sheet:10000
wait_for '^settings.scene=sheet:10000$'
wait_for '^frame.scale=1$'
[[ -n $(place MOTION/play) && -n $(place MOTION/time) ]] || fail "MOTION cannot be played at $SCREEN"
[[ $(value motion.time) == 0.0 ]] || fail "begins at $(value motion.time)"
move_to 640 712
see_picture first.png

# It plays: the time goes on in state and picture, and pixels that are pinned stay so.
hover 200 200
hold && let_go
wait_for '^pinned.x='
move_to 640 712
press space
wait_for '^motion.playing=true$'
wait_for '^motion.played=[1-9][0-9]$'
holds "$(value motion.time) > 0" || fail "no time passed"
see_picture playing.png
holds "$(difference first.png playing.png) > 0.01" || fail "the picture stands still"
press space
wait_for '^motion.playing=false$'
wait_for '^frame.scale=1$'
[[ $(value pinned.x) == 200 ]] || fail "the pinned pixel was let go"
at=$(value motion.time)
[[ $(value settings.time) == "$at" ]] || fail "settings say $(value settings.time), the scene $at"
sleep 1
[[ $(value motion.time) == "$at" ]] || fail "it goes on after it was stopped"
press Escape

# Steps of 1/30 s, by key and by button.
press shift+period
next=$(awk "BEGIN { t = $at + 1 / 30; print (t >= 4 ? t - 4 : t) }")
holds "($(value motion.time) - $next) ^ 2 < 1e-8" || fail "a step from $at leads to $(value motion.time)"
press shift+comma
click_on "MOTION/<"
click_on "MOTION/>"
holds "($(value motion.time) - $at) ^ 2 < 1e-12" || fail "steps lead to $(value motion.time), not back to $at"

# The slider, to a place and back to the beginning.
point_at "MOTION/time" 0.5 && hold && let_go
wait_for '^motion.time=[12]\.'
move_to 640 712
see_picture middle.png
holds "$(difference first.png middle.png) > 0.01" || fail "the slider moved nothing"
drag_slider "MOTION/time" 0.5 0.01
wait_for '^motion.time=0.0$'
move_to 640 712
see_picture again.png
[[ $(difference first.png again.png) == 0 ]] || fail "at time 0 it is another picture by $(difference first.png again.png)"

# Other schedules and trees, and another tracer while it plays.
choose "MOTION/schedule" on-demand
choose "MOTION/rebuild" refit
press space
wait_for '^motion.refitted=true$'
holds "$(value motion.frame_ms) >= 0" || fail "no frame time"
press v
wait_for '^frame.tracer=gl-fragment$' 120
wait_for '^motion.frames=[1-9]'
press space
wait_for '^motion.playing=false$'
[[ $(value messages) == "[]" ]] || fail "messages: $(state | grep '^messages')"
echo "passed"
