#!/usr/bin/env bash
# Tab goes between two settings, A and B, of one scene and one camera, and is no key for the fields of the panels.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
[[ $(value window.shown) == A ]] || fail "shows $(value window.shown) at first"
press Tab
wait_for '^window.shown=B$'
[[ $(value settings.traversal) == stack ]] || fail "B is no copy of A at first"
press t
wait_for '^settings.traversal=restart$'
press m
map=$(value settings.view.map.name)
[[ $map != nodes ]] || fail "M changed no map"
press Tab
wait_for '^window.shown=A$'
wait_for '^settings.traversal=stack$'
wait_for '^settings.view.map.name=nodes$'
wait_for '^counters.primary.restarts=0$'

# One camera and one scene for both.
hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2))
hold && move_by 4 10 3 && let_go
eye=$(value camera.eye.0)
press Tab
wait_for '^settings.traversal=restart$'
wait_for "^settings.view.map.name=$map\$"
[[ $(value camera.eye.0) == "$eye" ]] || fail "another camera in B"
choose "top/scene" rooms
wait_for '^scene.name=rooms$'
click_on "top/A"
wait_for '^settings.traversal=stack$'
[[ $(value scene.name) == rooms ]] || fail "A has the scene before"
click_on "top/A"
[[ $(value window.shown) == A ]] || fail "a click on what is shown went to the other"

# After a slider was used Tab is still the window's, and opens no field.
drag_slider "TREE/leaf size" 0.2 0.4
press Tab
wait_for '^window.shown=B$'
press h
wait_for '^settings.view.map.shown=false$'
echo "passed"
