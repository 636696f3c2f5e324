#!/usr/bin/env bash
# TIME: frames of the size that is asked for are timed; dragged high, the panel gives the plot its whole width.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
wait_for '^duel.rounds=[1-9]'
for row in upload compile; do
    [[ -n $(place "TIME/$row") ]] || fail "'$row' is not to be seen at $SCREEN"
    holds "$(value "duel.${row}_ms") > 0" || fail "$row took $(value "duel.${row}_ms") ms"
done
choose "TIME/size" half
wait_for "^duel.width=$((($(value frame.width) + 1) / 2))$"
wait_for '^duel.rounds=[3-9]'
press t
wait_for '^settings.traversal=restart$'
wait_for "^duel.width=$((($(value frame.width) + 1) / 2))$"

width_of() { place "$1" | cut -d' ' -f3; }
holds "$(width_of TIME/plot) < 700" || fail "the plot is $(width_of TIME/plot) wide beside the numbers"
top=$(value picture_area.1) height=$(value picture_area.3)
edge=$((${top%.*} + ${height%.*} + 2))
move_to 600 "$edge"
hold
move_by 10 0 -12
let_go
holds "$(width_of TIME/plot) > 900" || fail "the plot is $(width_of TIME/plot) wide in a high panel"

# The height that was dragged is every panel's, and the next window's.
high=$(value picture_area.3)
holds "$high < ${height%.*} - 100" || fail "the picture is still $high high"
press x
wait_for '^bottom=NEEDS$'
[[ $(value picture_area.3) == "$high" ]] || fail "NEEDS has another height"
stop_window
start_window ball:300
[[ $(value picture_area.3) == "$high" ]] || fail "the height was forgotten: $(value picture_area.3), not $high"
echo "passed"
