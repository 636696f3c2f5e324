#!/usr/bin/env bash
# A million rays each to edges and vertices of a closed sphere: no traversal of kdscope's loses one.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
bench watertight_bench | tee misses.txt
rows=$(grep -c '^kdscope .* 0  *0$' misses.txt || true)
((rows >= 6)) || { echo "FAIL: $rows traversals of 6 lose nothing" && exit 1; }
echo "passed"
