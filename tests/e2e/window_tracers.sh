#!/usr/bin/env bash
# TRACING's tracer: every one makes the same picture with the same counters; packets have a size; V goes between the last tracers of both machines.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
totals() { state | grep '^counters\.'; }
traced_by() { wait_for "^frame.tracer=$1$" && wait_for '^frame.scale=1$'; }
traced_by cpu
totals >cpu.txt
see_picture cpu.png
[[ -z $(place "TRACING/packet") ]] || fail "tracer cpu walks no packets"

# same_as_cpu TRACER MOST: the same counts, and a picture that differs by MOST at most (mean of 0..1). The CPU's differ in
# no bit; those of GL by what tests/gl/equality_gl_test.cpp grants GPUs, as rounding to 8 bits keeps a mean difference.
same_as_cpu() {
    totals | cmp -s cpu.txt - || fail "$1 counts otherwise: $(totals | diff cpu.txt -)"
    see_picture "$1.png"
    holds "$(difference cpu.png "$1.png") <= $2" || fail "$1 makes another picture: $(difference cpu.png "$1.png")"
}
for tracer in cpu-wide cpu-packet; do
    choose "TRACING/tracer" "$tracer"
    traced_by "$tracer"
    same_as_cpu "$tracer" 0
done
choose "TRACING/packet" 4
wait_for '^settings.packet_size=4$'
traced_by cpu-packet
same_as_cpu cpu-packet 0

# Blocks of eight: larger leaves, fewer nodes.
nodes=$(value tree.nodes)
click_on "TREE/more constants"
drag_slider "TREE/leaf block" 0.02 0.47
wait_for '^settings.build.leaf_block=[789]$'
holds "$(value tree.nodes) < $nodes" || fail "$(value tree.nodes) nodes with blocks, $nodes without"
click_on "TREE/default"
wait_for '^settings.build.leaf_block=1$'
wait_for "^tree.nodes=$nodes$"

wait_for '^gpu.(renderer=.|unavailable=.)'
if [[ -n $(value gpu.unavailable) ]]; then
    echo "passed on the CPU: no OpenGL 4.3 here: $(value gpu.unavailable)"
    exit 0
fi
press v
traced_by gl-fragment
for tracer in gl-wavefront gl-compute; do
    choose "TRACING/tracer" "$tracer"
    traced_by "$tracer"
    same_as_cpu "$tracer" 0.0005
done
hover 20 20
press v
traced_by cpu-packet
press v
traced_by gl-compute
echo "passed"
