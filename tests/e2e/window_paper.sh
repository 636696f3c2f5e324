#!/usr/bin/env bash
# PAPER: the experiments run behind the window, figures grow while they do, a click on a bar shows its scene, a run is cancelled.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
press shift+y
wait_for '^bottom=PAPER$'
for label in quick full; do
    [[ -n $(place "PAPER/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
click_on "PAPER/quick"
wait_for '^paper.active=true$'

# What is counted is there before anything is timed.
wait_for '^paper.figures.figure-13=' 120
[[ -z $(value paper.rounds) || $(value paper.rounds) == 0 ]] || fail "rounds before the counts"
click_on "PAPER/figure-13"
wait_for '^paper.figure=figure-13$'
[[ -n $(place "PAPER/figure") ]] || fail "there is no chart"
# The chart gets a group of bars for each scene that is counted; the last one is wanted.
wait_for '^paper.what=(nodes|loops|preparing|warming|round)' 240
point_at "PAPER/figure" 0.9 && hold && let_go
wait_for '^settings.scene=sheet:10000$' 60

# Rounds come in, with verdicts; what was found stays when the run is cancelled.
wait_for '^paper.rounds=[1-9]' 240
[[ -n $(value "paper.verdicts.E1b") ]] || fail "no verdict on E1b"
click_on "PAPER/Verdicts"
click_on "PAPER/cancel"
wait_for '^paper.active=false$'
holds "$(value paper.rounds) >= 1" || fail "the rounds are gone"
press shift+y
wait_for '^bottom=TIME$'
echo "passed"
