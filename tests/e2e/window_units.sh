#!/usr/bin/env bash
# A scene far larger than usual: the pixel's distance, the camera and the figure's settings are in the scene's own units.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window "$KD_SOURCE_DIR/tests/fixtures/app/large_square.gltf"
[[ $(value camera.eye.2) =~ ^3145728(\.0)?$ ]] || fail "the camera is at $(value camera.eye.2)"
x=$(($(value frame.width) / 2)) y=$(($(value frame.height) / 2))
hover "$x" "$y"
wait_for "^hovered.x=$x$"
holds "$(value hovered.primary.t) > 3145727 && $(value hovered.primary.t) < 3145900" || fail "t is $(value hovered.primary.t)"
press ctrl+c
press f
press ctrl+v
[[ $(value camera.eye.2) =~ ^3145728(\.0)?$ ]] || fail "pasted, the camera is at $(value camera.eye.2)"
echo "passed"
