#!/usr/bin/env bash
# The stack traversal makes three quarters of Embree's speed at least, on the scene whose number is published.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented
bench embree_bench ball:9000
echo "passed"
