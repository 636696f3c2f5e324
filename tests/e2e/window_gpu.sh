#!/usr/bin/env bash
# V changes to the GPU's four passes: the same counters to the last visit, and both machines are timed while idle.
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
press v
wait_for '^settings.tracer=cpu$'
see_picture cpu.png
holds "$(difference cpu.png gpu.png) < 0.001" || fail "the pictures differ: $(difference cpu.png gpu.png)"

wait_for '^duel.rounds=([2-9]|[1-9][0-9])' 60
holds "$(value duel.cpu_ms) > 0 && $(value duel.gl_ms) > 0" || fail "a machine was not timed"
echo "passed"
