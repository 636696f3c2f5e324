#!/usr/bin/env bash
# The whole stability suite on the CPU passes, and fails where it has to: under the published rules.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }

"$KDSCOPE" stability --tracer cpu --json >suite.json 2>errors.txt || fail "a case failed: $(grep -o '"reason": "[^"]*"' suite.json | head -3)"
cases=$(grep -o '"case": "T[0-9]*"' suite.json | sort -u | wc -l)
((cases >= 55)) || fail "only $cases cases ran"
# A tenth of a million rays in every row, but for cases whose number is their own (docs/stability.md says which).
few=$(awk -F'"' '/"case":/ { id = $4 } /"tracer":/ { tracer = $4 }
    /"n":/ { n = $3; gsub(/[^0-9]/, "", n); if (tracer == "cpu" && n + 0 < 100000) print id }' suite.json | sort -u | tr '\n' ' ')
known="T02 T05 T09 T10 T11 T12 T13 T24 T36 T40 T41 T42 T44 T50 T51 T58 T61 "
[[ "$few" == "$known" ]] || fail "fewer than 100000 rays in $few; expected in $known"
if "$KDSCOPE" stability --tracer cpu --rules as-published --case T10,T11,T12,T15,T16,T32 --json >published.json 2>>errors.txt; then
    fail "the published rules pass"
fi
failing=$(grep -c '"verdict": "fail"' published.json)
((failing == 18)) || fail "$failing of 18 rows fail under the published rules"
echo "passed"
