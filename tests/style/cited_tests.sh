#!/usr/bin/env bash
# Every test that the documents name is there, in the folder of its label, and so is every script of the tests.
set -uo pipefail
cd "$KD_SOURCE_DIR" || exit 1
documents=(README.md CONTRIBUTING.md docs/*.md)

# is_there LABEL SUITE NAME: a name of numbers alone, as F03, stands for all that begin with it; "*" for a whole suite.
is_there() {
    local name="$3\b" folder="tests/$1"
    [[ $3 =~ ^[A-Z][0-9]+$ ]] && name="$3(\b|[A-Z_])"
    [[ $3 == "*" ]] && name=""
    [[ -d $folder ]] || return 1
    grep -rqE "^(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\($2, *$name" "$folder"
}
is_there core Sah CostByHand && is_there "" GlFaults F03 && is_there gl MedianInterval '*' &&
    ! is_there core Sah CostBy && ! is_there gl Sah CostByHand && ! is_there "" NoSuite '*' ||
    { echo "FAIL: this check tells no test from another"; exit 1; }

failed=0 cited=0
while IFS=: read -r document test; do
    test=${test//\`/} test=${test//'*/'/} label=""
    [[ $test =~ ^[a-z] ]] && label=${test%%.*} test=${test#*.}
    is_there "$label" "${test%%.*}" "${test#*.}" || { echo "FAIL: $document names $label.$test"; failed=1; }
    cited=$((cited + 1))
done < <(grep -oE '`(([a-z]+\.)?(\*/)?[A-Z][A-Za-z0-9]+\.([A-Z][A-Za-z0-9]*|\*))`' "${documents[@]}")
while IFS=: read -r document script; do
    [[ -n $(find tests docs cmake -name "${script//\`/}") ]] || { echo "FAIL: $document names $script"; failed=1; }
    cited=$((cited + 1))
done < <(grep -oE '`[a-z_]+\.sh`' "${documents[@]}")
((cited > 40)) || { echo "FAIL: only $cited names were found"; exit 1; }
((failed == 0)) || exit 1
echo "passed: $cited names"
