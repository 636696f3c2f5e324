#!/usr/bin/env bash
# NODES: a node is selected in the icicle, in the slice, by the pinned pixel and by steps along its ray, and marked in all views.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

# What is seen of a control's place, while the mouse rests in the picture's corner.
see_place() {
    local at
    hover 3 3
    sleep 0.3  # the state file may be one frame ahead of the screen
    read -r -a at < <(place "$1")
    import -window root -crop "${at[2]%.*}x${at[3]%.*}+${at[0]%.*}+${at[1]%.*}" +repage "$2"
}
differ() { [[ $(compare -metric AE "$1" "$2" null: 2>&1) != 0 ]] || fail "$3"; }

start_window ball:1000
press i
wait_for '^bottom=NODES$'
wait_for '^nodes.icicle='
wait_for '^nodes.slice='
[[ $(value nodes.colour) == visits ]] || fail "nodes begin with colours by $(value nodes.colour), not by visits of this frame"
wait_for '^nodes.coloured=true$'
see_place "NODES/icicle" icicle.png
see_place "NODES/slice" slice.png
see_picture picture.png

# A click in the icicle: on the child below the root's plane, which is the node after it.
click_on "NODES/node 1"
wait_for '^selected.path=b$'
see_place "NODES/icicle" icicle_b.png
see_place "NODES/slice" slice_b.png
see_picture picture_b.png
differ icicle.png icicle_b.png "the node selected is not marked in the icicle"
differ slice.png slice_b.png "the node selected is not marked in the slice"
differ picture.png picture_b.png "the node selected is not marked in the picture"

# A click in the slice selects the leaf there.
point_at "NODES/slice" 0.5 && hold && let_go
wait_for '^selected.leaf=true$'
see_place "NODES/icicle" icicle_leaf.png
differ icicle_b.png icicle_leaf.png "the leaf selected is not marked in the icicle"
press Escape
wait_for '^selected=null$'

# Pinning a pixel selects the leaf in which its ray hit; the triangle's leaves are ticked, and the ray is in the slice.
hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2))
press p
wait_for '^selected.leaf=true$'
[[ $(value selected.node) == "$(value hit.leaf)" ]] || fail "leaf $(value selected.node) is selected, the hit is in $(value hit.leaf)"
[[ $(value hit.triangle) == "$(value pinned.primary.triangle)" ]] || fail "another triangle is marked"
holds "$(value hit.leaves) >= 1" || fail "no leaf lists the triangle"
see_place "NODES/icicle" icicle_hit.png
see_place "NODES/slice" slice_hit.png
differ icicle.png icicle_hit.png "the leaf of the hit is not marked in the icicle"
differ slice.png slice_hit.png "ray and triangle are not in the slice"
click_on "NODES/hit"
wait_for '^nodes.slice_share=0\.[0-9]*$'
[[ $(value nodes.slice_share) != 0.5 ]] || fail "the slice did not go to the hit"

# So do steps along its ray.
press period
wait_for '^step.node='
wait_for "^selected.node=$(value step.node)\$"
press Escape
wait_for '^selected=null$'
wait_for '^pinned=null$'

# Into the icicle and back; other axes; colours that are counted.
point_at "NODES/node 1"
xdotool click --repeat 2 --delay 1 1  # held apart by waiting, they would be no double click
wait_for '^nodes.root=b$'
click_on "NODES/whole tree"
wait_for '^nodes.root=$'
click_on "NODES/x"
wait_for '^nodes.slice_axis=0$'
see_place "NODES/icicle" icicle_visits.png
for colour in depth predicted ratio; do
    choose "NODES/colours" $colour
    wait_for "^nodes.colour=$colour\$"
    wait_for '^nodes.coloured=true$'
    see_place "NODES/icicle" icicle_$colour.png
    differ icicle_visits.png icicle_$colour.png "$colour looks like visits"
done

# A triangle by itself: where a click in the slice meets one. It is marked in picture, slice and icicle.
see_place "NODES/slice" slice_x.png
see_picture picture_x.png
point_at "NODES/triangle in slice" && hold && let_go
wait_for '^hit.has_ray=false$'
see_place "NODES/slice" slice_triangle.png
see_place "NODES/icicle" icicle_triangle.png
see_picture picture_triangle.png
differ slice_x.png slice_triangle.png "the triangle selected is not marked in the slice"
differ icicle_ratio.png icicle_triangle.png "the leaves of the triangle selected are not marked in the icicle"
differ picture_x.png picture_triangle.png "the triangle selected is not marked in the picture"
press Escape
wait_for '^hit=null$'
choose "NODES/width" "surface area"
sleep 1
see_place "NODES/icicle" icicle_area.png
differ icicle_ratio.png icicle_area.png "another width, and the same icicle"
echo "passed"
