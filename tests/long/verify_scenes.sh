#!/usr/bin/env bash
# Every traversal, builder and machine against brute force, of scenes at rest and in motion, and every feature put back.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }

models=/usr/share/assimp/models/glTF2
[[ -d $models ]] || { echo "no assimp-testmodels" && exit 77; }
model() { find "$models" -name "$1" | head -1; }

# all_pass NAME SCENES OPTION...: verify with these options passes each of so many scenes, and checks everything.
all_pass() {
    local file=$1.json scenes=$2 passed left_out
    shift 2
    "$KDSCOPE" verify "$@" --json >"$file" || fail "verify $*"
    passed=$(grep -c '"passed": true' "$file" || true)
    ((passed == scenes)) || fail "$passed of $scenes scenes pass in $file"
    # A mode that was not checked fails nothing by itself. Only the engine has more triangles than naive has steps.
    left_out=$(grep 'not checked' "$file" | grep -v '"naive with references on .*: 110336 triangles' || true)
    [[ -z $left_out ]] || fail "in $file: $left_out"
}

all_pass rest 5 ball:9000 rooms scatter:2000 cornell "$(model 2CylinderEngine.glb)"
all_pass holes 1 topiary:500
for time in 0.7 2 3.3; do
    all_pass "time-$time" 3 ball:2000 scatter:1000 sheet:2000 --time "$time"
done
all_pass needs 5 --needs ball:9000 cornell "$(model 2CylinderEngine.glb)" "$(model BoxTextured.glb)" \
    "$(model ClearCoatTest.gltf)"
all_pass needs-images 2 --needs topiary sheet:5000
all_pass needs-samples 3 --needs cornell ball:1000 topiary:500 --samples 1
all_pass needs-moved 2 --needs sheet:5000 ball:1000 --time 1.3
echo "passed"
