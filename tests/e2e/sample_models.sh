#!/usr/bin/env bash
# Every glTF 2.0 model of Debian's assimp-testmodels, good or broken: exit code 0, or 2 with one line that names the file,
# never a signal and never a sanitizer's report. KD_MODELS names another folder.
set -u
models=${KD_MODELS:-/usr/share/assimp/models/glTF2}
if [[ ! -d $models ]]; then
    echo "the package assimp-testmodels is not installed"
    exit 77
fi
rm -rf work && mkdir work && cd work || exit 1

shown=0 refused=0 failed=0
fail() {
    echo "FAIL: $*"
    head -n 20 err.txt
    failed=$((failed + 1))
}

# check MODEL ARGUMENTS...: runs kdscope, which must end well or refuse the file
check() {
    local model=$1 code lines
    shift
    "$KDSCOPE" "$@" >out.txt 2>err.txt </dev/null
    code=$?
    lines=$(wc -l <err.txt)
    case $code in
        0) [[ $lines -eq 0 ]] || fail "$model: exit code 0 with $lines lines on standard error" ;;
        2) [[ $lines -eq 1 && $(<err.txt) == "kdscope: $model: "* ]] || fail "$model: not one line that names it" ;;
        *) fail "$model: exit code $code" ;;
    esac
    return "$code"
}

while IFS= read -r -d '' model; do
    if check "$model" render "$model" -o picture.png --size 16x16 --tracer cpu --threads 1; then
        shown=$((shown + 1))
        [[ -s picture.png ]] || fail "$model: no picture"
    else
        refused=$((refused + 1))
        [[ ! -e picture.png ]] || fail "$model: a picture of a file that was refused"
    fi
    rm -f picture.png
done < <(find "$models" -type f \( -name '*.gltf' -o -name '*.glb' \) -print0 | sort -z)

echo "$shown shown, $refused refused in one line, $failed failed"
[[ $failed -eq 0 && $shown -ge 20 && $refused -ge 15 ]] || exit 1
echo "passed"
