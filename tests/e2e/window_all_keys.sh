#!/usr/bin/env bash
# Keys of F1 that no other script of this folder presses do what the help says, seen in the state file.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
press_for() { press "$1" && wait_for "$2" 30; }

press_for m '^settings.view.map.name=([^n]|n[^o])'
press_for c '^settings.view.map.colormap=([^v]|v[^i])'
press_for g '^settings.view.map.log=true$'
press_for g '^settings.view.map.log=false$'
press_for l '^settings.view.map.range.1='
press_for n '^settings.view.map.range=automatic$'
press_for bracketright '^settings.view.overlay.depth=7$'
press_for bracketleft '^settings.view.overlay.depth=6$'
press_for k '^window.legend=false$'
press_for k '^window.legend=true$'
press_for y '^bottom=STABILITY$'
press_for y '^bottom=TIME$'
press_for shift+d '^bottom=DIVERGENCE$'
press_for shift+d '^bottom=TIME$'
press_for shift+y '^bottom=PAPER$'
press_for shift+y '^bottom=TIME$'
press_for u '^window.panels=false$'
press_for u '^window.panels=true$'
press_for F1 '^window.help=true$'
press_for F1 '^window.help=false$'
press_for question '^window.help=true$'
press_for Escape '^window.help=false$'
press_for Prior '^window.fly_speed=2(\.0)?$'
press_for Next '^window.fly_speed=1(\.0)?$'
press_for o '^window.camera_style=fly$'
press_for o '^window.camera_style=orbit$'

# The pinned pixel, step by step.
x=$(($(value frame.width) / 2)) y=$(($(value frame.height) / 2))
hover "$x" "$y"
press_for p "^pinned.x=$x$"
press_for Left "^pinned.x=$((x - 1))$"
press_for Right "^pinned.x=$x$"
press_for Up "^pinned.y=$((y - 1))$"
press_for Down "^pinned.y=$y$"

# Another target, another orbit centre; R brings the scene's own back.
camera() { state | grep '^camera\.'; }
own=$(camera)
expect_camera() {
    [[ $1 == other && $(camera) != "$own" ]] || [[ $1 == own && $(camera) == "$own" ]] || fail "$2: the camera is not $1"
}
press f
expect_camera other "F"
press_for Escape '^pinned=null$'
other=$(camera)
press ctrl+c
press r
expect_camera own "R"
press ctrl+v
[[ $(camera) == "$other" ]] || fail "another camera was pasted: $(diff <(camera) <(echo "$other"))"
press r
hover $((x + 15)) $((y + 20))
hold && let_go
# Both clicks may come within one frame.
xdotool click --repeat 2 --delay 1 1
for _ in $(seq 300); do [[ $(camera) != "$own" ]] && break || sleep 0.1; done
expect_camera other "double click"
press r
press_for F12 '^last_export=.*kdscope-1.png$'
echo "passed"
