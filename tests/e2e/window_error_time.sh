#!/usr/bin/env bash
# ERROR: the resting picture is sampled and its error falls, another traversal is another curve of it, and a click on a configuration
# goes back to it and can be undone.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
press e
wait_for '^bottom=ERROR$'
for label in sample stop independent stratified "undo click"; do
    [[ -n $(place "ERROR/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
wait_for '^convergence.tried=1$'

# Four times the samples: about half the error.
click_on "ERROR/sample"
wait_for '^convergence.active=true$'
wait_for '^convergence.samples=(4|5|6|7)$' 60
early=$(state | sed -n 's/^convergence.curves.independent, stack, cpu=//p')
wait_for '^convergence.samples=(6[4-9]|[7-9][0-9]|[1-5][0-9][0-9])$' 120
late=$(state | sed -n 's/^convergence.curves.independent, stack, cpu=//p')
holds "$late < 0.7 * $early && $late > 0" || fail "the error went from $early to $late"

# Another traversal goes on with the same picture.
press t
wait_for '^settings.trace.traversal=restart$'
wait_for '^convergence.curves.independent, restart, cpu=0.0' 60
[[ -n $(state | sed -n 's/^convergence.curves.independent, stack, cpu=//p') ]] || fail "the first curve is gone"
click_on "ERROR/stop"
wait_for '^convergence.active=false$'
wait_for '^convergence.tried=[2-9]'

# The nearest point to the middle of the chart is one of those tried; undoing goes to where we were.
before=$(value settings.trace.traversal)
point_at "ERROR/tried" 0.5 && hold && let_go
click_on "ERROR/undo click"
wait_for "^settings.trace.traversal=$before\$"

press shift+y
wait_for '^bottom=PAPER$'
press e
press e
wait_for '^bottom=TIME$'
echo "passed"
