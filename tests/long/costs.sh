#!/usr/bin/env bash
# Counters, recording and safety cost at most what costs_bench says when nobody asks for them, in all of the CPU's tracers.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented
bench costs_bench
echo "passed"
