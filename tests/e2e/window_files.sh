#!/usr/bin/env bash
# A file that is dropped onto the window is shown; the list of scenes has its name, also the next time; a bad one is told.
SCREEN=1280x900  # SCENE is unfolded
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"
command -v python3 >/dev/null || skip "python3 is not installed"

drop() { python3 "$(dirname -- "${BASH_SOURCE[0]}")/drop_file.py" "$window" 500 300 "$1" || fail "dropping $1"; }
deep=$PWD/a-folder-with-a-long-name/another-folder-with-a-long-name
mkdir -p "$deep"
cp "$KD_SOURCE_DIR/tests/fixtures/app/large_square.gltf" "$deep/Würfel 1.gltf"
start_window ball:300
drop "$deep/Würfel 1.gltf"
wait_for '^settings.scene=.*/Würfel 1.gltf$'
wait_for '^scene.triangles=2$'

choose "top/scene" rooms
wait_for '^settings.scene=rooms$'
choose "top/scene" "$deep/Würfel 1.gltf"
wait_for '^settings.scene=.*/Würfel 1.gltf$'
drop "$KD_SOURCE_DIR/README.md"
wait_for '^messages.*README.md.*not a .gltf or .glb file'
[[ $(value settings.scene) == *Würfel* ]] || fail "the scene before is gone: $(value settings.scene)"

# Typed: a name with its size, then a path; a wrong one is told.
open_typed() {
    click_on "SCENE/open"
    xdotool type --delay 20 "$1"
    press Return
}
open_typed scatter:700
wait_for '^scene.triangles=700$'
open_typed "$KD_SOURCE_DIR/tests/fixtures/app/large_square.gltf"
wait_for '^scene.triangles=2$'
wait_for '^window.scene_text=$'
open_typed sctter:600
wait_for '^messages.*sctter'
wait_for '^scene.triangles=2$'

# It stays, with the reason below it and nothing over that, to be mended.
[[ $(value window.scene_text) == sctter:600 ]] || fail "what was typed is gone: '$(value window.scene_text)'"
wait_for '^places.SCENE/refused.0='
state | grep -q '^places.*tooltip' && fail "a tooltip lies over the reason"
# The field has the keys again: who goes on typing there presses no keys of the window.
press Home
press Right
press Right
xdotool type a
press Return
wait_for '^scene.triangles=600$'
wait_for '^window.scene_text=$'
[[ -z $(place SCENE/refused) ]] || fail "still told as refused"
state | grep -q '^messages.*sctter' && fail "what was mended is still told over the picture"

kill -TERM "$window_pid" && wait "$window_pid"
window_pid=
start_window ball:300
choose "top/scene" "$deep/Würfel 1.gltf"
wait_for '^scene.triangles=2$'
echo "passed"
