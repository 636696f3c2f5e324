#!/usr/bin/env bash
# kdscope's tracers hit as Embree does, and the best of each kind keep the least share of its speed that docs/performance.md promises.
set -euo pipefail

source "$KD_SOURCE_DIR/tests/support/bench.bash"
skip_where_instrumented

# against_embree FILE ARGUMENTS...: bench --peers, its rows into the file.
against_embree() {
    local status=0
    "$KDSCOPE" bench "${@:2}" --peers --json >"$1" 2>errors.txt || status=$?
    if grep -q "built without Embree" errors.txt; then echo "SKIPPED: $(cat errors.txt)" && exit 77; fi
    ((status == 0)) || { echo "FAIL: bench --peers ended with $status" && cat errors.txt && exit 1; }
}
against_embree peers.json ball:1000 ball:9000 ball:100000 rooms scatter:10000 --rounds 11
against_embree threads.json ball:100000 --threads 2 --rounds 7
python3 - peers.json threads.json <<'PYTHON'
import json, sys
rows, on_threads = (json.load(open(name)) for name in sys.argv[1:])
# All of them answer, Embree's too: what does not work is fast. Of rays from hits some meet an edge where roundings decide, 1 of 253440
# random ones on ball:9000, so ten times that is too many; Embree's own rows differed in none.
for row in rows + on_threads:
    if row["tracer"] == "spin":
        continue
    most = 0 if row["ray_type"] == "primary" else 4e-5 * row["rays"]
    told = (row["scene"], row["tracer"], row["ray_type"], row["packet"], row["hits"], row["differ"])
    assert row["hits"] > 0, told
    assert row["differ"] <= most, told
own = [row for row in rows if row["tracer"].startswith("cpu")]
scalar, single, packets = ["cpu"], ["cpu", "cpu-wide"], ["cpu-packet"]
# Of the speed of Embree's robust mode, with rays like their own: single, or packets of 16. The best of these tracers, in whichever tree.
floors = [
    (scalar, "ball:9000", "primary", 0.75),
    (single, "ball:9000", "primary", 1.3),
    (single, "rooms", "primary", 1.0),
    (single, "scatter:10000", "primary", 0.75),
    (single, "ball:9000", "random", 0.65),
    (single, "rooms", "random", 0.8),
    (single, "scatter:10000", "random", 0.5),
    (packets, "ball:1000", "primary", 1.1),
    (packets, "ball:9000", "primary", 1.1),
    (packets, "rooms", "primary", 1.1),
    (packets, "ball:100000", "primary", 0.9),
    (packets, "ball:1000", "shadow", 0.9),
    (packets, "rooms", "shadow", 0.9),
]
missed = 0
for tracers, scene, ray_type, floor in floors:
    speeds = [
        next(of["median"] for peer, of in row["speed_of"].items() if peer.endswith("-robust"))
        for row in own
        if row["tracer"] in tracers and row["scene"] == scene and row["ray_type"] == ray_type
    ]
    best = max(speeds)
    missed += best < floor
    print(f"{'/'.join(tracers)}, {ray_type} rays on {scene}: {best:.2f} of Embree, at least {floor}{' MISSED' if best < floor else ''}")
assert not missed, f"{missed} of {len(floors)} missed"
# Of what a spin loop gains from two threads beside them: each tracer in the tree that suits it.
gains = [
    row
    for row in on_threads
    if row["threads"] == 2 and row["tree"] == ("asked" if row["tracer"] == "cpu" else row["tracer"]) and row["packet"] in (1, 16)
]
assert len(gains) == 9, [(row["tracer"], row["ray_type"], row["packet"]) for row in gains]
missed = 0
for row in gains:
    of_spin = row["gain_of_spin"]["median"]
    missed += of_spin < 0.9
    print(f"{row['tracer']}, {row['ray_type']} rays on two threads: {of_spin:.2f} of a spin loop's gain, at least 0.9{' MISSED' if of_spin < 0.9 else ''}")
assert not missed, f"{missed} of {len(gains)} gains missed"
PYTHON
echo "passed"
