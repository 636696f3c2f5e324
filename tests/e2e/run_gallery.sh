#!/usr/bin/env bash
# ./run from another folder: without arguments and display it writes the gallery, with arguments it passes them on.
# Only the release build has this test, for ./run brings that build up to date.
set -u
unset DISPLAY WAYLAND_DISPLAY
fail() {
    echo "FAIL: $*"
    exit 1
}
# png_number FILE OFFSET: the big-endian number of four bytes there
png_number() {
    local -a bytes
    read -ra bytes < <(od -An -tu1 -j "$2" -N 4 "$1")
    echo $(((bytes[0] << 24) + (bytes[1] << 16) + (bytes[2] << 8) + bytes[3]))
}

rm -rf work && mkdir work && cd work || exit 1
touch -d '1 second ago' began

"$KD_SOURCE_DIR/run" >paths.txt 2>err.txt || fail "./run: exit code $?: $(cat err.txt)"
kinds=
while IFS= read -r path; do
    [[ $path =~ ^out/(ball|rooms|scatter|lantern).*-(beauty|nodes|divergence|splits)\.png$ ]] ||
        fail "not a picture: $path"
    kinds+="${BASH_REMATCH[1]} ${BASH_REMATCH[2]}"$'\n'
    file=$KD_SOURCE_DIR/$path
    [[ $file -nt began ]] || fail "$path was not written"
    [[ $(od -An -tx1 -N 8 "$file") == " 89 50 4e 47 0d 0a 1a 0a" ]] || fail "$path is no PNG"
    width=$(png_number "$file" 16) height=$(png_number "$file" 20)
    ((width >= 640 && width <= 1280 && height >= 480 && height <= 960)) || fail "$path is ${width}x$height"
    (($(stat -c %s "$file") > 5000)) || fail "$path has $(stat -c %s "$file") bytes"
done <paths.txt
[[ $(sort -u <<<"${kinds%$'\n'}" | wc -l) -eq 16 ]] || fail "not four pictures of each of four scenes: $(cat paths.txt)"
different=$(while IFS= read -r path; do sha256sum <"$KD_SOURCE_DIR/$path"; done <paths.txt | sort -u | wc -l)
[[ $different -eq 16 ]] || fail "only $different of the pictures differ from each other"

"$KD_SOURCE_DIR/run" stats cornell >stats.txt 2>err.txt || fail "./run stats cornell: exit code $?: $(cat err.txt)"
grep -q '^cornell: ' stats.txt || fail "no table: $(cat stats.txt)"

# A path is the caller's, not the checkout's.
"$KD_SOURCE_DIR/run" render cornell -o here.png --size 24x24 >/dev/null 2>err.txt || fail "./run render: $(cat err.txt)"
[[ -s here.png ]] || fail "a relative path is not taken from the folder that ./run was called in"

# The pictures are no change to the checkout, where it is one.
if git -C "$KD_SOURCE_DIR" rev-parse --git-dir >/dev/null 2>&1; then
    git -C "$KD_SOURCE_DIR" check-ignore -q out/ball.png || fail "git does not ignore out/"
fi
echo "passed"
