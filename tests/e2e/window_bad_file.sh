#!/usr/bin/env bash
# A file that cannot be shown leaves the old scene, and a message says why; what a good file lost is told.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

mkdir -p assets/scenes
cp "$KD_SOURCE_DIR"/tests/fuzz/corpus/gltf/{empty.gltf,points.glb,skinned.glb} assets/scenes/
head -c 100 "$KD_SOURCE_DIR/tests/fixtures/io/two_colours.jpg" >assets/scenes/jpeg.glb
export KDSCOPE_ASSETS=$PWD/assets

start_window ball:300
see_picture ball.png
for bad in "empty.gltf: holds no triangle" "points.glb: holds no triangle that can be shown: skipped 1 primitive" \
    "jpeg.glb: GLB header: bad magic"; do
    choose "top/scene" "${bad%%:*}"
    wait_for "^messages.*=.*$bad"
    wait_for '^settings.scene=ball:300$'
    [[ $(value scene.name) == ball:300 ]] || fail "the old scene is gone"
done

choose "top/scene" skinned.glb
wait_for '^scene.name=skinned.glb$'
wait_for '^messages.*=.*skinned.glb: ignored 1 animation channel, whose times are not SCALAR of float'
see_picture skinned.png
stop_window
echo "passed"
