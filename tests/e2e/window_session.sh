#!/usr/bin/env bash
# Ctrl+S saves a session: given to the program, typed or dropped it brings back settings and counters; a bad one changes nothing.
SCREEN=1280x900  # SCENE is unfolded
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

# What the state file tells of the settings, and the counters of the frame.
shown() { state | grep -E '^(settings|counters)\.'; }
same_as() { shown >now.txt && cmp -s "$1" now.txt || fail "not as it was saved: $(diff "$1" now.txt)"; }

cp "$KD_SOURCE_DIR/tests/fixtures/app/large_square.gltf" square.gltf
start_window square.gltf --leaf-size 4
press t && wait_for '^settings.traversal=restart$'
press m && press l && wait_for '^settings.view.map.locked=true$'
press bracketright && wait_for '^settings.view.overlay.depth=7$'
hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2))
hold && move_by 4 10 3 && let_go
wait_for '^settings.camera.eye.0='
press ctrl+s
wait_for '^messages.*=wrote .*kdscope-1.session.json$'
[[ $(value settings.view.overlay.shown) == true ]] || fail "Ctrl+S is taken for S"
grep -q '"scene": "square.gltf"' kdscope-1.session.json || fail "the scene beside it is not named relative to it"
shown >saved.txt
click_on "EXPORT/session"
wait_for '^last_export=.*kdscope-2.session.json$'
cmp -s kdscope-1.session.json kdscope-2.session.json || fail "button and key save different sessions"
click_on "EXPORT/picture"
wait_for '^last_export=.*kdscope-3.png$'
stop_window

# At the start, from another folder: the scene is found all the same.
mkdir elsewhere && cd elsewhere || exit 1
start_window ../kdscope-1.session.json
shown | grep -v '^settings.scene=' >now.txt
grep -v '^settings.scene=' ../saved.txt | cmp -s - now.txt || fail "not as it was saved: $(diff ../saved.txt now.txt)"
[[ $(value settings.scene) == ../square.gltf ]] || fail "the scene is $(value settings.scene)"
stop_window
cd ..

# Typed, while another scene is shown.
start_window ball:300
open_typed() {
    click_on "SCENE/open"
    xdotool type --delay 20 "$1"
    press Return
}
open_typed kdscope-1.session.json
wait_for '^settings.traversal=restart$'
wait_for '^scene.triangles=2$'
wait_for '^window.scene_text=$'
same_as saved.txt
click_on "EXPORT/picture"
wait_for '^last_export=.*kdscope-4.png$'
[[ $(difference kdscope-3.png kdscope-4.png) == 0 ]] || fail "another picture"

# One that is wrong stays in its field, with the reason below.
sed 's/"leaf_size": 4/"leaf_size": 0/' kdscope-1.session.json >bad.json
open_typed bad.json
wait_for '^messages.*bad.json: /settings/build/leaf_size: 0 is not a whole number'
wait_for '^places.SCENE/refused.0='
[[ $(value window.scene_text) == bad.json ]] || fail "what was typed is gone: '$(value window.scene_text)'"
same_as saved.txt

if command -v python3 >/dev/null; then
    press Escape
    press t
    wait_for '^settings.traversal=[^r]'
    python3 "$(dirname -- "${BASH_SOURCE[0]}")/drop_file.py" "$window" 500 300 "$PWD/kdscope-1.session.json" || fail "dropping"
    wait_for '^settings.traversal=restart$'
fi
stop_window

# The same frame without the window.
"$KDSCOPE" render kdscope-1.session.json --no-legend -o r.png --json r.json >/dev/null || fail "render does not take it"
KDSCOPE_STATE_FILE=r.json shown >r.txt
grep '^counters' r.txt >a.txt && grep '^counters' saved.txt >b.txt && cmp -s a.txt b.txt || fail "other counters: $(diff a.txt b.txt)"
[[ $(difference kdscope-3.png r.png) == 0 ]] || fail "render makes another picture"
echo "passed"
