#!/usr/bin/env bash
# What the robust rules cost in steps and in time, on the scenes whose bounds robustness_bench keeps.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented
bench robustness_bench
echo "passed"
