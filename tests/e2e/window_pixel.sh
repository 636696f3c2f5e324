#!/usr/bin/env bash
# The read-out of a pixel holds the numbers that `kdscope render --csv` writes for it; a click pins it, Esc lets it go.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

# show SCENE TRAVERSAL: in the window, and what the command line writes for a picture of its size.
show() {
    start_window "$1" --traversal "$2"
    width=$(value frame.width)
    height=$(value frame.height)
    "$KDSCOPE" render "$1" --traversal "$2" --size "${width}x${height}" -o r.png --csv r.csv >/dev/null || fail "render failed"
}
# table X Y COLUMN: of the pixel, from what the command line wrote for the same picture.
table() {
    awk -F, -v x="$1" -v y="$2" -v name="$3" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
        $1 == x && $2 == y { print $c; exit }' r.csv
}
columns=(triangle interior_first interior_again leaves triangle_tests restarts backtracks stack_depth)

# Every counter of every ray that the pixel has; one without a hit in the table has no reading.
check_pixel() {
    local x=$1 y=$2 rays name shown written
    hover "$x" "$y"
    wait_for "^hovered.x=$x$" && wait_for "^hovered.y=$y$"
    for rays in primary shadow reflection; do
        [[ -n $(value "hovered.$rays.leaves") ]] || continue
        ((++readings[$rays]))
        for name in "${columns[@]}"; do
            shown=$(value "hovered.$rays.$name") written=$(table "$x" "$y" "${rays}_$name")
            [[ $shown == "$written" ]] || fail "pixel $x,$y: $rays $name is $shown in the window, $written in the table"
        done
        shown=$(value "hovered.$rays.exit") written=$(table "$x" "$y" "${rays}_exit_reason")
        [[ $shown == "$written" ]] || fail "pixel $x,$y: $rays exit is $shown in the window, $written in the table"
    done
    # Distance along a primary ray, in the table in full and in the window as a number of its own.
    shown=$(value hovered.primary.t) written=$(table "$x" "$y" primary_t)
    [[ $(table "$x" "$y" primary_triangle) == -1 ]] ||
        awk -v a="$shown" -v b="$written" 'BEGIN { exit !(a > 0 && (a - b) ^ 2 <= (1e-6 * b) ^ 2) }' ||
        fail "pixel $x,$y: t is $shown in the window, $written in the table"
}

declare -A readings=([primary]=0 [shadow]=0 [reflection]=0)
for walk in backtrack stack restart; do
    show cornell "$walk"
    for at in "2 2" "3 2" "3 4" "4 3" "5 4" "60 60"; do
        read -r across down <<<"$at"
        check_pixel $((width / across)) $((height / down))
    done
    stop_window
done
for rays in primary shadow reflection; do
    ((readings[$rays] > 0)) || fail "no $rays ray was read"
done

show ball:1000 restart
check_pixel $((width / 2)) $((height / 2))
check_pixel $((width / 3)) $((height / 4))
check_pixel 5 5

# A click pins; the mouse may go elsewhere.
hover $((width / 2)) $((height / 2))
wait_for "^hovered.x=$((width / 2))$"
hold && let_go
wait_for "^pinned.x=$((width / 2))$"
tests=$(value pinned.primary.triangle_tests)
hover 20 30
wait_for '^hovered.x=20$'
[[ $(value pinned.primary.triangle_tests) == "$tests" ]] || fail "the pinned pixel moved with the mouse"
press Right
wait_for "^pinned.x=$((width / 2 + 1))$"
press Escape
wait_for '^pinned=null$'

# Moved and clicked within one frame, while the window is held: the press pins, and the way there turns nothing.
camera() { state | grep '^camera\.'; }
camera_before=$(camera)
hover 20 30
moves=$(inputs move) buttons=$(inputs button)
left=$(value picture_area.0) top=$(value picture_area.1)
kill -STOP "$window_pid"
xdotool mousemove $((${left%.*} + width / 3)) $((${top%.*} + height / 3)) click 1
kill -CONT "$window_pid"
answered move "$moves" 1
answered button "$buttons" 2
[[ $(camera) == "$camera_before" ]] || fail "a jump of the mouse to a click turned the camera"
wait_for "^pinned.x=$((width / 3))$"
wait_for "^pinned.y=$((height / 3))$"
press Escape
wait_for '^pinned=null$'

# A drag orbits and pins nothing.
camera_before=$(value counters.primary.interior_first)
hover $((width / 2)) $((height / 2))
hold && move_by 6 12 4 && let_go
[[ $(value counters.primary.interior_first) != "$camera_before" ]] || fail "dragging did not turn the camera"
[[ $(value pinned) == null ]] || fail "a drag pinned a pixel"
press r
wait_for "^counters.primary.interior_first=$camera_before$"

# PIXEL reads the rays of the map, or those chosen there.
[[ $(value pixel_rays) == primary ]] || fail "reads $(value pixel_rays) rays at first"
choose "VIEW/rays" shadow
wait_for '^pixel_rays=shadow$'
choose "PIXEL/rays" reflection
wait_for '^pixel_rays=reflection$'
choose "VIEW/rays" primary
wait_for '^settings.view.map.rays=primary$'
[[ $(value pixel_rays) == reflection ]] || fail "the choice went with the map"
choose "PIXEL/rays" "the map's"
wait_for '^pixel_rays=primary$'
echo "passed"
