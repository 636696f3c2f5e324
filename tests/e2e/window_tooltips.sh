#!/usr/bin/env bash
# A tooltip does not lie over what the press of its button made: it rests until the mouse has left and come back.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
tooltip() { state | grep -q '^places\..*tooltip\.0='; }
# Presses a button after its tooltip was there, and finds it gone.
press_button() {
    point_at "$1"
    wait_for '^places\..*tooltip\.0='
    hold
    let_go
    tooltip && fail "a tooltip lies over the result of $1"
}

press y
click_on "STABILITY/all traversals"
press_button "STABILITY/run"
wait_for '^stability.passed=' 240
wait_for '^stability.active=false$'
tooltip && fail "the tooltip came back with the verdicts"
press_button "STABILITY/charts"
point_at "STABILITY/run"
wait_for '^places\.STABILITY/tooltip\.0='
press_button "STABILITY/sweep"
wait_for '^stability.active=true$'
tooltip && fail "a tooltip lies over the sweep"
click_on "STABILITY/cancel"

press shift+y
press_button "PAPER/quick"
wait_for '^paper.active=true$'
click_on "PAPER/cancel"
wait_for '^paper.active=false$'

press x
press_button "NEEDS/measure"
wait_for '^needs.active=true$'
wait_for '^needs.active=false$' 120
tooltip && fail "the tooltip lies over what was measured"
point_at "NEEDS/leave all out"
point_at "NEEDS/measure"
wait_for '^places\.NEEDS/tooltip\.0='
echo "passed"
