#!/usr/bin/env bash
# Faults of docs/stability.md as the commands meet them: one line that says why, the exit code, and no half file.
set -u
rm -rf work && mkdir work && cd work || exit 1
fail() {
    echo "FAIL: $*"
    exit 1
}
gl=(render ball:300 --size 64x48 --tracer gl-fragment -o out.png)

# refused NAME CODE PATTERN VARIABLE=VALUE... -- ARGUMENTS...: fails with that exit code and one line that matches.
refused() {
    local name=$1 code=$2 pattern=$3 variables=() status
    shift 3
    while [[ $1 != -- ]]; do variables+=("$1") && shift; done
    shift
    env ${variables[@]+"${variables[@]}"} "$KDSCOPE" "$@" >out.txt 2>err.txt
    status=$?
    [[ $status -eq $code ]] || fail "$name: exit code $status, not $code: $(cat err.txt)"
    [[ $(wc -l <err.txt) -eq 1 ]] || fail "$name: not one line: $(cat err.txt)"
    grep -qE "$pattern" err.txt || fail "$name: $(cat err.txt)"
    [[ ! -e out.png ]] || fail "$name: a file was written"
    [[ -z $(find . -name '.kdscope*') ]] || fail "$name: a temporary file was left"
}

refused F01 3 'no OpenGL context \(egl\).*--tracer cpu' __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent -- "${gl[@]}" --context egl
"$KDSCOPE" "${gl[@]}" >/dev/null 2>err.txt || {
    [[ $? -eq 3 && $(wc -l <err.txt) -eq 1 ]] || fail "no OpenGL: $(cat err.txt)"
    echo "SKIPPED: $(cat err.txt)"
    exit 77
}
rm out.png
software=$("$KDSCOPE" info | grep -c 'software')
if ((software > 0)); then
    refused F02 3 'OpenGL 4.3.*--tracer cpu' MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 -- "${gl[@]}"
fi
env MESA_GL_VERSION_OVERRIDE=3.3 "$KDSCOPE" render ball:300 --size 64x48 -o out.png >/dev/null || fail "F02: the CPU needs no OpenGL"
rm out.png

# F03: the compiler's log, with file and line, follows the line.
cp -r "$KD_SOURCE_DIR/shaders" broken
sed -i '5i nonsense' broken/shared/box.glsl
KD_SHADER_DIR=broken "$KDSCOPE" "${gl[@]}" >/dev/null 2>err.txt
[[ $? -eq 3 ]] || fail "F03: not exit code 3"
head -1 err.txt | grep -q '^kdscope: shader fragment/.*frag does not compile:$' || fail "F03: $(cat err.txt)"
grep -q 'shaders/shared/box.glsl:[56]' err.txt || fail "F03 names no line: $(cat err.txt)"
[[ ! -e out.png ]] || fail "F03: a file was written"

# F04: a compiler that takes NaN for a number.
cp -r "$KD_SOURCE_DIR/shaders" fast
sed -i 's/return !(IS_NAN(a.x).*/return !(abs(a.x) > limit) \&\& !(abs(a.y) > limit) \&\& !(abs(a.z) > limit);/' fast/shared/ray.glsl
refused F04 3 "fails the self-test: ray .*invalid ray.*--tracer cpu" KD_SHADER_DIR=fast -- "${gl[@]}"
KD_SHADER_DIR=fast "$KDSCOPE" info >out.txt || fail "F04: info fails"
grep -q 'fails the self-test' out.txt || fail "F04: info does not tell: $(cat out.txt)"
"$KDSCOPE" info | grep -q 'self-test passed' || fail "F04: info does not tell of a good one"

refused F05 2 '(nodes|triangles) take [0-9]+ texels, a texture buffer holds 700 here' KDSCOPE_FAULT=texels:700 -- "${gl[@]}"
refused F05 2 '64x48 pixels: a texture holds 50x50 here' KDSCOPE_FAULT=side:50 -- "${gl[@]}"
refused F06 3 'out of memory while .*--tracer cpu' KDSCOPE_FAULT=memory:9000 -- "${gl[@]}"
refused F08 3 'the GPU was reset while' KDSCOPE_FAULT=lost:1 -- "${gl[@]}"

# F12: no room, or no right to write.
if [[ -w /dev/full ]]; then
    printf 'ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n' >rays.csv
    refused F12 2 "cannot write '/dev/full': No space left on device" -- trace ball:300 --tracer cpu --rays rays.csv -o /dev/full
fi
refused F12 2 "/proc/out.png.*(No such file|Permission|not permitted)" -- render ball:300 --size 8x8 -o /proc/out.png
mkdir -p full
if mount -t tmpfs -o size=64k none full 2>/dev/null; then
    trap 'umount full' EXIT
    "$KDSCOPE" render ball:300 --size 8x8 -o full/old.png >/dev/null || fail "F12: a small file does not fit"
    cp full/old.png before.png
    refused F12 2 'full/big.csv: No space left on device' -- render ball:300 --size 200x200 -o small.png --csv full/big.csv
    refused F12 2 'full/old.png: No space left on device' -- render scatter:5000 --size 900x900 -o full/old.png
    cmp -s full/old.png before.png || fail "F12: the old file is not whole"
    [[ $(ls -A full) == old.png ]] || fail "F12: left behind: $(ls -A full)"
else
    echo "SKIPPED in part: F12 on a full disk, since this user cannot mount one"
fi

# F15: a limit on memory. Under a sanitizer the program needs the whole address space.
if [[ -z ${ASAN_OPTIONS:-} ]]; then
    (
        ulimit -v 250000
        refused F15 2 'not enough memory' -- render scatter:1000000 --size 64x48 -o out.png
    ) || exit 1
fi
echo "passed"
