#!/usr/bin/env bash
# ERROR: the resting picture is sampled and its error falls, another traversal is another curve of it, and a click on a configuration
# goes back to it and can be undone.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
click_on "TIME/measure while idle"  # or each round moves the points of the configurations
press e
wait_for '^bottom=ERROR$'
for label in sample stop independent stratified "undo click"; do
    [[ -n $(place "ERROR/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
wait_for '^convergence.tried=[1-9]'

# From 2 to 16 samples and more the error falls: by the root, were the first not by chance.
click_on "ERROR/sample"
wait_for '^convergence.active=true$'
wait_for '^convergence.curves.independent, stack, cpu.points=[4-9]$' 120
early=$(value "convergence.curves.independent, stack, cpu.first")
late=$(value "convergence.curves.independent, stack, cpu.last")
holds "$late < 0.8 * $early && $late > 0" || fail "the error went from $early to $late"

# Another traversal goes on with the same picture.
press t
wait_for '^settings.traversal=restart$'
wait_for '^convergence.curves.independent, restart, cpu.points=' 60
[[ -n $(value "convergence.curves.independent, stack, cpu.last") ]] || fail "the first curve is gone"
click_on "ERROR/stop"
wait_for '^convergence.active=false$'
wait_for '^convergence.tried=[2-9]'

# The point of the first configuration goes back to it; undoing goes to where we were.
[[ $(value settings.traversal) == restart ]] || fail "another traversal: $(value settings.traversal)"
click_on "ERROR/tried/CPU 0"
wait_for '^settings.traversal=stack$'
click_on "ERROR/undo click"
wait_for '^settings.traversal=restart$'

press shift+y
wait_for '^bottom=PAPER$'
press e
press e
wait_for '^bottom=TIME$'
echo "passed"
