#!/usr/bin/env bash
# A full stop and a comma step along the pinned pixel's ray, leaf by leaf, lit in the picture; so do the buttons of PIXEL.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
press h
hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2))
see_picture plain.png
# Without a pinned pixel the first step pins the one under the mouse.
press period
wait_for '^pinned.x='
wait_for '^step.node='
leaves=$(value step.count)
[[ $leaves == "$(value pinned.primary.leaves)" && $leaves -ge 3 ]] || fail "$leaves leaves to step through, the ray visited $(value pinned.primary.leaves)"
see_picture first.png
holds "$(difference plain.png first.png) > 0.001" || fail "the first leaf is not on the screen"

enters=$(value step.enters) node=$(value step.node)
for ((i = 2; i <= leaves; i++)); do
    left=$(value step.leaves)
    press period
    wait_for "^step.enters=$left\$"
    holds "$(value step.enters) >= $enters" || fail "leaf $i begins at $(value step.enters), before $enters"
    enters=$(value step.enters)
done
[[ $(value step.leaves) == "$(value pinned.primary.t)" ]] || fail "the last leaf ends at $(value step.leaves), the hit is at $(value pinned.primary.t)"
last=$(value step.node)
press period
[[ $(value step.node) == "$last" ]] || fail "there is a leaf after the last"
see_picture last.png
holds "$(difference first.png last.png) > 0.001" || fail "the last leaf looks like the first"

for ((i = leaves; i > 1; i--)); do press comma; done
wait_for "^step.node=$node\$"
click_on "PIXEL/>"
wait_for "^step.enters=$(value step.enters)\$"
[[ $(value step.node) != "$node" ]] || fail "the button > steps nowhere"
click_on "PIXEL/<"
wait_for "^step.node=$node\$"
press comma
wait_for '^step=null$'
press period
wait_for "^step.node=$node\$"
press Escape
wait_for '^step=null$'

# The leaves are those of the walk, with the ones that robust rules look into beside the ray, and of the published walk.
choose "top/scene" rooms
wait_for '^scene.name=rooms$'
same_number() {
    press period
    wait_for '^step.count='
    [[ $(value step.count) == "$(value pinned.primary.leaves)" ]] ||
        fail "$1: $(value step.count) leaves to step through, the ray visited $(value pinned.primary.leaves)"
}
for x in 3 4 5; do
    hover $(($(value frame.width) * x / 9)) $(($(value frame.height) * x / 9))
    press p
    same_number robust
    press Escape
    wait_for '^pinned=null$'
done
press p
press t
wait_for '^settings.traversal=restart$'
same_number restart
echo "passed"
