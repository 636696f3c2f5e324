#!/usr/bin/env bash
# Trees of 100 000 triangles take at most three times Embree's build of high quality (exact), six times its medium one
# (binned), on two threads; those of a million five times the one of high quality. Fails where the 95 % interval of 15
# rounds says that they do not.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented
bench build_bench ball:100000
bench build_bench scatter:100000
bench build_bench ball:1000000
echo "passed"
