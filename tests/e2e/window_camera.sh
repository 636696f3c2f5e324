#!/usr/bin/env bash
# The camera by hand: the wheel comes closer, Shift+drag pans, a drag orbits, W and S with the right button held fly.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

# Numbers of the camera: its distance to the target, and how far eye or target are from those kept by keep().
numbers() { value "camera.$1.0" && value "camera.$1.1" && value "camera.$1.2"; }
keep() { kept_eye=$(numbers eye | xargs) kept_target=$(numbers target | xargs) kept_distance=$(distance); }
far() { echo "$1 $2" | awk '{ print sqrt(($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2) }'; }
distance() { far "$(numbers eye | xargs)" "$(numbers target | xargs)"; }
eye_moved() { far "$(numbers eye | xargs)" "$kept_eye"; }
target_moved() { far "$(numbers target | xargs)" "$kept_target"; }

# Waits for the eye to have moved and the whole picture to be there.
wait_for_move() {
    for _ in $(seq 100); do
        sleep 0.1
        holds "$(eye_moved) > 0.01" && sleep 0.5 && return
    done
    fail "the eye did not move: $1"
}
drag() {
    hold "$1"
    for _ in 1 2 3 4 5 6; do xdotool mousemove_relative -- 12 6 && sleep 0.05; done
    let_go "$1"
}

start_window ball:300
middle() { hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2)) && sleep 0.15; }
middle
keep
for _ in 1 2 3; do xdotool click 4 && sleep 0.1; done
wait_for_move "wheel"
holds "$(distance) < 0.9 * $kept_distance && $(target_moved) < 1e-4" || fail "the wheel did not come closer"

keep
xdotool keydown shift && drag 1 && xdotool keyup shift
wait_for_move "Shift+drag"
holds "$(distance) - $kept_distance < 1e-3 && $kept_distance - $(distance) < 1e-3" || fail "panning changed the distance"
holds "$(target_moved) > 0.01" || fail "panning left the target"

middle
keep
drag 1
wait_for_move "drag"
holds "$(target_moved) < 1e-4" || fail "an orbit moved the target"
[[ $(value pinned) == null ]] || fail "a drag pinned a pixel"

middle
keep
hold 3 && xdotool keydown s && sleep 0.6 && xdotool keyup s && let_go 3
wait_for_move "S"
[[ -z $(value settings.view.overlay.depth) ]] || fail "S switched the splits on while flying"
holds "$(target_moved) > 0.01" || fail "flying left the target behind"
back=$(eye_moved)
keep
hold 3 && xdotool keydown w && sleep 0.6 && xdotool keyup w && let_go 3
wait_for_move "W"
holds "$(eye_moved) > 0.05 * $back" || fail "W went nowhere"
echo "passed"
