#!/usr/bin/env bash
# Every case of bad input in docs/stability.md has a test that carries its number, and no number is left out.
set -uo pipefail
cd "$KD_SOURCE_DIR" || exit 1
rows=$(sed -n '/^## Bad input/,/^## Fuzzing/p' docs/stability.md | grep '^| [GCS][0-9]')
failed=0
check() {
    grep -qE "^\| [^|]*\b$1\b[^|]*\|" <<<"$rows" || { echo "FAIL: $1 is not in docs/stability.md"; failed=1; }
    grep -rqE "\b$1(\b|[A-Z_])" tests/io tests/app tests/e2e || { echo "FAIL: no test carries $1"; failed=1; }
}
for i in {01..28}; do check "G$i"; done
for i in {01..12}; do check "C$i"; done
for i in {01..10}; do check "S$i"; done
[[ $failed -eq 0 ]] || exit 1
echo "passed"
