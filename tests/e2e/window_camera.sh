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

moved() { holds "$(eye_moved) > 0.01" || fail "the eye did not move: $1"; }
drag() { hold "$1" && move_by 6 12 6 && let_go "$1"; }
# Holds a key: fly KEY BUTTON. No picture is complete before the key is let go.
fly() {
    local keys
    hold "$2"
    keys=$(inputs key)
    xdotool keydown "$1" && sleep 0.8 && xdotool keyup "$1"
    answered key "$keys" 2
    let_go "$2"
}

start_window ball:300
middle() { hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2)); }
middle
keep
scrolls=$(inputs scroll)
for _ in 1 2 3; do xdotool click 4; done
answered scroll "$scrolls" 3
moved "wheel"
holds "$(distance) < 0.9 * $kept_distance && $(target_moved) < 1e-4" || fail "the wheel did not come closer"

keep
xdotool keydown shift && drag 1 && xdotool keyup shift
moved "Shift+drag"
holds "$(distance) - $kept_distance < 1e-3 && $kept_distance - $(distance) < 1e-3" || fail "panning changed the distance"
holds "$(target_moved) > 0.01" || fail "panning left the target"

middle
keep
drag 1
moved "drag"
holds "$(target_moved) < 1e-4" || fail "an orbit moved the target"
[[ $(value pinned) == null ]] || fail "a drag pinned a pixel"

middle
keep
fly s 3
moved "S"
[[ $(value settings.view.overlay.shown) == false ]] || fail "S switched the splits on while flying"
holds "$(target_moved) > 0.01" || fail "flying left the target behind"
keep
fly w 3
moved "W"

# O: a drag looks around, and letters fly while it lasts.
press r
press o
wait_for '^window.camera_style=fly$'
middle
keep
drag 1
holds "$(eye_moved) < 1e-4 && $(target_moved) > 0.01" || fail "looking around moved the eye, or nothing"
keep
fly w 1
moved "W while looking around"
press o
wait_for '^window.camera_style=orbit$'
echo "passed"
