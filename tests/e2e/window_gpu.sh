#!/usr/bin/env bash
# V changes to the GPU's four passes: the same counters to the last visit, and both machines are timed while idle. The
# paper's early z culls nothing, and makes the same picture.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000 --traversal restart
wait_for '^gpu.(renderer=.|unavailable=.)'
[[ -z $(value gpu.unavailable) ]] || skip "no OpenGL 4.3 here: $(value gpu.unavailable)"
totals() { state | grep '^counters\.'; }
totals >cpu.txt

press v
wait_for '^settings.tracer=gl-fragment$'
wait_for '^frame.scale=1$'
totals >gpu.txt
cmp -s cpu.txt gpu.txt || fail "counters differ: $(diff cpu.txt gpu.txt)"
see_picture gpu.png

pixels=$(($(value frame.width) * $(value frame.height)))
[[ $(value shaded_pixels.RTPrim) -eq $pixels ]] || fail "RTPrim shaded $(value shaded_pixels.RTPrim) of $pixels pixels"
hits=$(value shaded_pixels.ShadePrim)
((hits > 0 && hits < pixels && $(value shaded_pixels.RTRefl) < hits)) || fail "early z culls nothing: $hits"
click_on "TRACING/passes and rules"
choose "TRACING/early z" "as published"
wait_for '^settings.early_z=as-published$'
for pass in ShadePrim RTRefl ShadeRefl; do
    [[ $(value shaded_pixels.$pass) -eq $pixels ]] || fail "as published, pass $pass shades $(value shaded_pixels.$pass)"
done
totals | cmp -s cpu.txt - || fail "counters depend on early z"
see_picture published.png
holds "$(difference gpu.png published.png) < 0.001" || fail "the picture depends on early z"
choose "TRACING/early z" working
wait_for "^shaded_pixels.ShadePrim=$hits$"

hover 20 20
press v
wait_for '^settings.tracer=cpu$'
see_picture cpu.png
holds "$(difference cpu.png gpu.png) < 0.001" || fail "the pictures differ: $(difference cpu.png gpu.png)"

wait_for '^duel.rounds=([2-9]|[1-9][0-9])' 60
holds "$(value duel.cpu_ms) > 0 && $(value duel.gl_ms) > 0" || fail "a machine was not timed"
echo "passed"
