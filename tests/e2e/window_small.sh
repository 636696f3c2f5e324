#!/usr/bin/env bash
# 1280x720: what does not fit scrolls, and can be reached; EXPORT stays in view beside a long PIXEL.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

# Turns the wheel over a control until another is to be seen: scroll_to OVER LABEL up|down.
scroll_to() {
    local before step=5
    [[ $3 == up ]] && step=4
    point_at "$1"
    for _ in $(seq 20); do
        [[ -n $(place "$2") ]] && return
        before=$(inputs scroll)
        xdotool click "$step"
        answered scroll "$before" 1
    done
    fail "'$2' cannot be scrolled to"
}
# Whether all of a control lies above the place Y.
above() { read -r -a at < <(place "$1") && holds "${at[1]} + ${at[3]} <= $2"; }

start_window rooms --rules as-published
bottom=$(value picture_area.1)
bottom=$((${bottom%.*} + $(value picture_area.3 | cut -d. -f1)))
above "EXPORT/folder" "$bottom" || fail "EXPORT does not fit beside PIXEL: $(place "EXPORT/folder")"
above "PIXEL/release pixel" "$bottom" || fail "PIXEL does not fit: $(place "PIXEL/release pixel")"
click_on "top/Oracle"
wait_for '^oracle.wrong=[1-9]'
for label in EXPORT EXPORT/figure EXPORT/JSON EXPORT/folder; do
    above "$label" "$bottom" || fail "'$label' was pushed off: $(place "$label")"
done
[[ -n $(place "PIXEL/verdict") ]] || fail "the verdict is not to be seen"
scroll_to "PIXEL/verdict" "PIXEL/release pixel" down
read -r -a export_header < <(place EXPORT)
above "PIXEL/release pixel" "${export_header[1]}" || fail "its last row is cut: $(place "PIXEL/release pixel")"

# The legend gives names and counts room.
read -r -a legend < <(place legend)
holds "${legend[2]} > 196" || fail "the legend is ${legend[2]} wide with long names"

# VIEW with the rows of groups.
press d
wait_for '^settings.view.map.name=divergence$'
scroll_to "VIEW/map" "VIEW/split lines" down
above "VIEW/split lines" 696 || fail "the last row of VIEW is cut: $(place "VIEW/split lines")"

# NEEDS shows whole rows; its last one can be reached.
press x
wait_for '^bottom=NEEDS$'
scroll_to "NEEDS/reflections" "NEEDS/exact-products" down

# STABILITY in a lower strip: the texts of a case go on below what is to be seen.
press y
wait_for '^bottom=STABILITY$'
move_to 600 $((bottom + 2)) && hold && move_by 5 0 12 && let_go
point_at "STABILITY/run"
above "STABILITY/accepted" 696 && fail "all texts of the case fit: $(place "STABILITY/accepted")"
for _ in 1 2 3 4 5 6; do
    scrolls=$(inputs scroll)
    xdotool click 5
    answered scroll "$scrolls" 1
done
above "STABILITY/accepted" 696 || fail "the end of the texts cannot be reached: $(place "STABILITY/accepted")"
echo "passed"
