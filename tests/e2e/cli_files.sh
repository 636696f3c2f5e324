#!/usr/bin/env bash
# Files (C09, C11): a full disk and a closed pipe are told, an old file survives a failure, names need not be ASCII.
set -u
rm -rf work && mkdir work && cd work || exit 1
fail() {
    echo "FAIL: $*"
    exit 1
}
small=(--size 24x24)

# A name that is not ASCII, and blanks.
"$KDSCOPE" render cornell -o "Bild ä 光.png" "${small[@]}" >/dev/null || fail "non-ASCII name"
[[ -s "Bild ä 光.png" ]] || fail "no file under a non-ASCII name"

# An existing file is replaced as a whole; a refused run leaves it alone.
cp "Bild ä 光.png" old.png
"$KDSCOPE" render nosuch -o old.png 2>err.txt && fail "a scene that does not exist was rendered"
cmp -s "Bild ä 光.png" old.png || fail "the old picture was touched"
[[ $(wc -l <err.txt) -eq 1 ]] || fail "not one line: $(cat err.txt)"

# Standard output that cannot take the text.
if [[ -w /dev/full ]]; then
    "$KDSCOPE" stats cornell >/dev/full 2>err.txt
    [[ $? -eq 2 ]] || fail "a full disk went unnoticed"
    [[ $(wc -l <err.txt) -eq 1 ]] || fail "not one line: $(cat err.txt)"
    "$KDSCOPE" trace cornell --rays /dev/null -o - >/dev/full 2>err.txt && fail "a full disk went unnoticed by trace"
fi

# Told before the work: these pictures would take minutes.
large=(ball:2000000 --size 4096x4096)
if [[ -w /dev/full ]]; then
    timeout 20 "$KDSCOPE" bench "${large[@]}" --json >/dev/full 2>err.txt
    [[ $? -eq 2 ]] || fail "a full disk was not told before the work: $(cat err.txt)"
fi
timeout 20 "$KDSCOPE" render "${large[@]}" -o large.png >&- 2>err.txt
[[ $? -eq 2 && $(wc -l <err.txt) -eq 1 && ! -e large.png ]] || fail "closed standard output: $(cat err.txt)"

# Standard input closed, nobody at the other end of the pipe.
"$KDSCOPE" stats cornell <&- >/dev/null || fail "closed standard input"
"$KDSCOPE" stats cornell --builders 2>err.txt | head -1 >/dev/null

# No temporary file is left over.
rm -f err.txt old.png "Bild ä 光.png"
[[ -z $(ls -A) ]] || fail "left behind: $(ls -A)"
echo "passed"
