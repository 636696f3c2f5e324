#!/usr/bin/env bash
# The stability suite with all rays of the notes, by all traversals on CPU and OpenGL.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }
source "$KD_SOURCE_DIR/tests/support/stability_rows.bash"

"$KDSCOPE" stability --long --json >long.json || fail "a case failed: $(cases_with_verdict fail long.json)"
cases=$(cases_in long.json)
((cases >= 55)) || fail "only $cases cases ran"
# Six traversals on each machine in nearly all of them, on OpenGL in both contexts; packets walk by the stack alone.
declare -A fewest=([cpu]=300 [cpu-wide]=300 [cpu-packet]=50 [gl-fragment]=600 [gl-compute]=600 [gl-wavefront]=600)
for tracer in "${!fewest[@]}"; do
    rows=$(rows_of tracer "$tracer" long.json)
    ((rows >= fewest[$tracer])) || fail "only $rows rows of $tracer"
done
# What may go wrong, flagged, is what docs/stability.md says.
for id in $(cases_with_mismatches long.json) $(cases_with_verdict exempt long.json); do
    [[ $id =~ ^(T04|T24|T28)$ ]] || fail "$id has mismatches, or is exempt"
done
# Packets of the other sizes, a tenth of the rays.
for size in 4 8; do
    "$KDSCOPE" stability --tracer cpu-packet --packet "$size" --json >packets.json ||
        fail "a case fails by packets of $size: $(cases_with_verdict fail packets.json)"
    rows=$(rows_of tracer cpu-packet packets.json)
    ((rows >= 50)) || fail "only $rows rows of packets of $size"
done
# Over nodes of 8 bytes a tenth of the rays.
"$KDSCOPE" stability --nodes 8 --json >packed.json || fail "a case fails over nodes of 8 bytes: $(cases_with_verdict fail packed.json)"
# So they are in every builder's trees, on the CPU.
builders=$("$KDSCOPE" info | sed -n 's/^builders *//p')
for builder in ${builders//,/}; do
    "$KDSCOPE" stability --builder "$builder" --tracer cpu --json >built.json ||
        fail "a case fails in trees of $builder: $(cases_with_verdict fail built.json)"
done
[[ $builder == object-median ]] || fail "the builders are $builders"
echo "passed"
