#!/usr/bin/env bash
# Files of code stay below 400 lines, so that each holds one concept.
set -uo pipefail
limit=400
cd "$KD_SOURCE_DIR" || exit 1
sizes=$(find app renderer viz shaders tests cmake \
    \( -name '*.cpp' -o -name '*.h' -o -name '*.glsl' -o -name '*.frag' -o -name '*.vert' -o -name '*.sh' -o -name '*.cmake' \) \
    -exec wc -l {} +) || exit 1
[[ $(wc -l <<<"$sizes") -gt 100 ]] || { echo "FAIL: the files were not found"; exit 1; }
long=$(awk -v limit=$limit '$2 != "total" && $1 >= limit { print $2 ": " $1 " lines" }' <<<"$sizes")
if [[ -n $long ]]; then
    echo "FAIL: split what is too long:"
    echo "$long"
    exit 1
fi
echo "passed"
