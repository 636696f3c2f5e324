#!/usr/bin/env bash
# STABILITY: a case is found, run, seen and swept; its parameter changes the scene shown; the scene before comes back.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300 --rules as-published
[[ $(value bottom) == TIME ]] || fail "the window begins with $(value bottom)"
height=$(value picture_area.3)
# All panels at the bottom are of one height.
for key in shift+y x e shift+d y; do
    press "$key"
    wait_for '^bottom=[^T]'
    [[ $(value picture_area.3) == "$height" ]] || fail "the picture is $(value picture_area.3) high with $(value bottom), $height with TIME"
done
wait_for '^bottom=STABILITY$'
for label in filter run sweep "show scene" verdicts charts "all traversals"; do
    [[ -n $(place "STABILITY/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
state | grep -q '^places.STABILITY/back to' && fail "a way back is offered, and no case was shown"

# The list narrows down to what is typed.
click_on "STABILITY/filter"
xdotool type --delay 60 vertices
for _ in $(seq 100); do [[ -z $(place "STABILITY/T01") ]] && break || sleep 0.1; done
[[ -z $(place "STABILITY/T01") ]] || fail "T01 has no vertices in its words"
click_on "STABILITY/T16"
wait_for '^stability.case=T16$'

# A run under the published rules fails and says so.
click_on "STABILITY/all traversals"
click_on "STABILITY/run"
wait_for '^stability.passed=false$' 240
wait_for '^stability.active=false$'
[[ $(value stability.rows.0.traversal) == stack ]] || fail "another traversal ran: $(value stability.rows.0.traversal)"
holds "$(value stability.rows.0.mismatches) > 0" || fail "nothing was lost as published"
click_on "STABILITY/row 0"
wait_for "places.STABILITY/copy.0="

# Its scene takes the picture's place.
see_picture ball.png
click_on "STABILITY/show scene"
wait_for '^settings.scene=stress:T16$'
see_picture sphere.png
holds "$(difference ball.png sphere.png) > 0.02" || fail "the picture stayed"

# A sweep: the published curve is lost near the vertex, the robust one stays at its bound.
click_on "STABILITY/sweep"
wait_for '^stability.active=true$'
wait_for '^stability.sweep_complete=true$' 280
wait_for '^stability.active=false$'
curve() { value "stability.curves.$1.$2"; }
[[ $(curve "robust, cpu" 0.2) == true ]] || fail "the robust rules lost rays"
holds "$(curve "robust, cpu" 0.1) == 0.0015" || fail "3/n is not 0.0015: $(curve "robust, cpu" 0.1)"
[[ $(curve "as-published, cpu" 0.2) == false ]] || fail "the published rules lost nothing"
holds "$(curve "as-published, cpu" 0.1) > 0.05" || fail "they lost only $(curve "as-published, cpu" 0.1)"
[[ -n $(place "STABILITY/faults") && -n $(place "STABILITY/ulps") ]] || fail "there are no charts"

# Clicking a point, and the slider, show the scene at that value; back brings the ball with its settings.
point_at "STABILITY/faults" 0.97 && hold && let_go
wait_for '^settings.scene=stress:T16=0.1$'
drag_slider "STABILITY/scene at" 0.95 0.02
wait_for '^settings.scene=stress:T16=1e-09$'
see_picture near.png
click_on "STABILITY/back to ball:300"
wait_for '^settings.scene=ball:300$'
[[ -z $(place "STABILITY/back to ball:300") ]] || fail "back to where we are"
see_picture again.png
holds "$(difference ball.png again.png) < 0.002" || fail "another picture came back"

# A run is cancelled; what has no parameter offers no sweep.
click_on "STABILITY/sweep"
wait_for '^stability.active=true$'
click_on "STABILITY/cancel"
wait_for '^stability.active=false$'
press y
wait_for '^bottom=TIME$'
stop_window

# The scenes are scenes everywhere.
"$KDSCOPE" render stress:T25=1e-3 -o slivers.png --size 64x48 --map nodes >/dev/null || fail "cannot be rendered"
[[ -s slivers.png ]] || fail "no picture"
"$KDSCOPE" render stress:T25=7 -o x.png 2>error.txt && fail "7 is no width"
[[ $(wc -l <error.txt) == 1 ]] || fail "not one line: $(cat error.txt)"
echo "passed"
