#!/usr/bin/env bash
# The paper's experiments, whole: every figure, and a verdict with its number on each claim that must be decided.
set -euo pipefail

fail() { echo "FAIL: $*" && exit 1; }

rm -rf paper
"$KDSCOPE" paper -o paper >told.txt || fail "exit code $?"
for name in figure-9 figure-11 figure-12-14 figure-13 restart-cost divergence loop-ceiling traversal-share verdicts \
    times counts loop-budgets run; do
    [[ -s paper/$name.csv ]] || fail "$name.csv is not there"
done
[[ -s paper/index.html && -s paper/results.json ]] || fail "no page"

rounds=$(grep -c '"ms":' paper/results.json || true)
((rounds >= 6 * 7 * 4)) || fail "only $rounds times were taken"
# E1a, E1b, E3a and E3b need no GPU: each has its number with an interval, and a reason.
for claim in "E1a CPURT" E1b "E3a scatter" "E3a sheet" "E3b scatter" "E3b sheet"; do
    row=$(grep "^$claim," paper/verdicts.csv) || fail "no verdict on $claim"
    [[ $row =~ ,(reproduced|"not reproduced"|undecided), ]] || fail "$claim has no verdict: $row"
    [[ $row == *"not measured"* ]] && fail "$claim was not measured"
    [[ $row == *"("*" – "*")"* ]] || fail "$claim has no interval: $row"
done
# Counts are the same on every machine: the cloud reproduces E3a, the sheet does not.
grep -q "^E3a scatter,.*,reproduced," paper/verdicts.csv || fail "E3a is not reproduced by the cloud"
grep -q "^E3a sheet,.*,not reproduced," paper/verdicts.csv || fail "E3a is reproduced by the sheet"
echo "passed"
