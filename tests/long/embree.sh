#!/usr/bin/env bash
# kdscope's tracers hit as Embree does, and the stack traversal makes three quarters of its speed at least, on the scene whose number is published.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented
status=0
"$KDSCOPE" bench ball:9000 --peers --json >peers.json 2>errors.txt || status=$?
if grep -q "built without Embree" errors.txt; then echo "SKIPPED: $(cat errors.txt)" && exit 77; fi
((status == 0)) || { echo "FAIL: bench --peers ended with $status" && cat errors.txt && exit 1; }
python3 - peers.json <<'PYTHON'
import json, sys
rows = json.load(open(sys.argv[1]))
own = [row for row in rows if not row["tracer"].startswith("embree")]
for row in own:
    assert row["differ"] == 0, (row["tracer"], row["ray_type"], row["differ"])
stack = next(row for row in own if row["tracer"] == "cpu" and row["ray_type"] == "primary")
speed = stack["speed_of"]["embree-1-robust"]["median"]
print(f"the stack makes {speed:.3f} of embree-1-robust's speed with primary rays")
assert speed >= 0.75, speed
PYTHON
echo "passed"
