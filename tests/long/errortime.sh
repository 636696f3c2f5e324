#!/usr/bin/env bash
# The six reports of error against run time on two scenes, whole: slopes, lines, and nothing that is wrong.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }

rm -rf et
begun=$SECONDS
"$KDSCOPE" errortime cornell ball:9000 -o et >files.txt || fail "exit code $?"
[[ -n ${KD_PATIENCE:-} ]] || ((SECONDS - begun < 900)) || fail "it took $((SECONDS - begun)) s, more than fifteen minutes"
while read -r file; do [[ -s $file ]] || fail "$file is not there"; done <files.txt
for file in index.html numbers.csv p1-cornell-slopes.csv p2.csv p3-ball-9000-tau.csv p4-ball-9000.csv p5-cornell.csv p6-cornell.csv; do
    grep -q "/$file\$" files.txt || fail "$file is not told"
done

# number NAME: in full, from the table of the page's numbers; empty where it is not there.
number() { { grep -F "$1" et/numbers.csv || true; } | head -1 | sed 's/.*,//'; }
# holds WHAT NUMBER LOW HIGH
holds() { awk -v x="$2" -v a="$3" -v b="$4" 'BEGIN { exit !(x != "" && x >= a && x <= b) }' || fail "$1 is $2, not $3 to $4"; }

machines=(cpu)
grep -q "gl-fragment" et/left-out.csv || machines+=(gl-fragment)
for scene in cornell ball:9000; do
    for machine in "${machines[@]}"; do
        independent=$(number "$scene: P1: independent, $machine, stack: slope\"")
        stratified=$(number "$scene: P1: stratified, $machine, stack: slope\"")
        holds "$scene: slope of independent samples on $machine" "$independent" -0.6 -0.4
        # An edge through a pixel: n^-3/4 (Mitchell 1996) where independent samples have n^-1/2; half of that at least.
        holds "$scene: slope of stratified samples on $machine" "$stratified" -1.2 \
            "$(awk -v s="$independent" 'BEGIN { print s - 0.125 }')"
    done
    # The variance of a mean falls by the number of samples; a sequence of low discrepancy beats that.
    holds "$scene: slope of the relMSE of independent light" \
        "$(number "$scene: P6: indirect light, independent, cpu: slope\"")" -1.15 -0.85
    holds "$scene: slope of the relMSE of the light's sequence" \
        "$(number "$scene: P6: indirect light, sequence, cpu: slope\"")" -2 -1.15
    holds "$scene: error of the lines, percent" "$(number "$scene: P3: largest error, percent")" 0 5
done
grep -q "<b>Wrong</b>" et/index.html && fail "the page names a fault"
echo "passed"
