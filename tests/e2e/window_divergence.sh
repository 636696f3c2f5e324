#!/usr/bin/env bash
# Groups in the window: schedules, other shapes, and efficiency against width at the bottom.
SCREEN=900x1300  # high enough for all of VIEW, and few pixels to walk
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000 --traversal restart
press d
wait_for '^settings.view.map.name=divergence$'
wait_for '^settings.view.map.schedule=lockstep$'
hover $(($(value frame.width) / 2)) $(($(value frame.height) / 2))
wait_for '^hovered.map='
holds "$(value hovered.map) > 0 && $(value hovered.map) <= 1" || fail "the efficiency under the mouse is $(value hovered.map)"
choose "VIEW/schedule" while-while
wait_for '^settings.view.map.schedule=while-while$'

# The curve comes by itself once nobody works; its rows choose the shape of the groups.
click_on "VIEW/efficiency against width"
wait_for '^bottom=DIVERGENCE$'
wait_for '^widths.points=7$'
wait_for '^widths.outdated=false$'
holds "$(value widths.overhead) > 1.5" || fail "restart visits $(value widths.overhead) times the nodes of a stack"
holds "$(value widths.narrowest) > $(value widths.widest)" || fail "wider groups lose nothing"
click_on "DIVERGENCE/width 256"
wait_for '^settings.view.map.tile_width=16$'
wait_for '^settings.view.map.tile_height=16$'

# Another traversal is another curve.
choose "TRACING/traversal" stack
wait_for '^widths.overhead=1(\.0)?$'
click_on "DIVERGENCE/times"
wait_for '^bottom=TIME$'
echo "passed"
