#!/usr/bin/env bash
# Ten thousand frames of a moving scene, in a pipeline: memory stays within 1 %, and the first frame repeats to the bit.
set -euo pipefail

options=(--dynamic --frames 10000 --schedule pipelined --size 64x48 --json)
for rebuild in binned refit; do
    for tracer in cpu-wide gl-fragment; do
        context=()
        [[ $tracer == gl-* ]] && context=(--context osmesa)
        "$KDSCOPE" bench sheet:2000 "${options[@]}" --rebuild $rebuild --tracer $tracer "${context[@]}" > soak.json ||
            { code=$?; [[ $code == 3 ]] && echo "no OpenGL: $tracer left out" && continue; echo "FAIL: $code"; exit 1; }
        python3 - "$rebuild by $tracer" << 'END'
import json, sys
row = json.load(open("soak.json"))[0]
begin, end = row["memory_begin"], row["memory_end"]
print(f"{sys.argv[1]}: {row['frames']} frames, {begin} bytes after the first round, {end} after the last")
assert row["frames"] == 10000 and row["first_frame_repeats"]
assert begin is None or abs(end - begin) <= 0.01 * begin, "memory"
END
    done
done
echo "passed"
