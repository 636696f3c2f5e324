#!/usr/bin/env bash
# The stability suite with all rays of the notes, by all traversals on CPU and OpenGL.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }
source "$KD_SOURCE_DIR/tests/support/stability_rows.bash"

"$KDSCOPE" stability --long --json >long.json || fail "a case failed: $(cases_with_verdict fail long.json)"
cases=$(cases_in long.json)
((cases >= 55)) || fail "only $cases cases ran"
# Six traversals on each machine in nearly all of them.
for machine in "tracer cpu" "context osmesa" "context egl"; do
    rows=$(rows_of $machine long.json)
    ((rows >= 300)) || fail "only $rows rows of $machine"
done
# What may go wrong, flagged, is what docs/stability.md says.
for id in $(cases_with_mismatches long.json) $(cases_with_verdict exempt long.json); do
    [[ $id =~ ^(T04|T24|T28)$ ]] || fail "$id has mismatches, or is exempt"
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
