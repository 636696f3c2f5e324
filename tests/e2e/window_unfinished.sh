#!/usr/bin/env bash
# Published rules give rays up: a badge over the picture counts their pixels and leads to the map of reasons.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
[[ $(value unfinished.pixels) == 0 ]] || fail "robust rules leave pixels unfinished"
[[ -z $(place "picture/unfinished") ]] || fail "a badge without a reason"
stop_window
rm -f "$KDSCOPE_STATE_FILE"

start_window cornell --rules first-edition --traversal backtrack --eye 0,1,60  # far away: the walks that never end take long
(($(value unfinished.step_cap) > 0)) || fail "no walk ended at the step cap"
click_on "picture/unfinished"
wait_for '^settings.view.map.name=exit$'
see_picture exit.png
press t
wait_for '^settings.traversal=push-down$' # of which no published form is kept
wait_for '^unfinished.pixels=0$'
[[ -z $(place "picture/unfinished") ]] || fail "the badge stayed"
echo "passed"
