#!/usr/bin/env bash
# Lists and help: a scene and a map are chosen in them; while one is open, keys are not commands, and Esc closes it and no more.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
see_picture ball.png
choose "top/scene" cornell
wait_for '^scene.name=cornell$'
wait_for '^settings.scene=cornell$'
see_picture cornell.png
holds "$(difference ball.png cornell.png) > 0.02" || fail "another scene, the same picture"
choose "top/map" triangles
wait_for '^settings.view.map.name=triangles$'
choose "VIEW/map" leaves
wait_for '^settings.view.map.name=leaves$'

hover 200 200
wait_for '^hovered.x=200$'
press p
wait_for '^pinned.x=200$'
click_on "TRACING/traversal"
point_at "TRACING/traversal/restart"
press t
press h
[[ $(value settings.traversal) == stack && $(value settings.view.map.shown) == true ]] || fail "keys acted behind an open list"
press Escape
[[ -z $(place "TRACING/traversal/restart") ]] || fail "Esc did not close the list"
[[ $(value pinned) != null ]] || fail "Esc for the list released the pixel"
[[ $(value settings.traversal) == stack ]] || fail "Esc chose something"
press Escape
wait_for '^pinned=null$'
press t
wait_for '^settings.traversal=restart$'

# Keys alone: from restart up to stack, by Esc nothing, and down again.
click_on "TRACING/traversal"
press Up
[[ $(value settings.traversal) == restart ]] || fail "an arrow chose already"
press Return
wait_for '^settings.traversal=stack$'
[[ -z $(place "TRACING/traversal/restart") ]] || fail "Enter did not close the list"
click_on "TRACING/traversal"
press Down
press Escape
[[ -z $(place "TRACING/traversal/restart") ]] || fail "Esc did not close the list"
[[ $(value settings.traversal) == stack ]] || fail "Esc took the line"
click_on "TRACING/traversal"
press Down
press Return
wait_for '^settings.traversal=restart$'

# The help takes clicks and keeps keys from what lies behind it; text of another size is drawn, not a blank window.
press F1
wait_for '^window.help=true$'
press t
[[ $(value settings.traversal) == restart ]] || fail "a key acted behind the help"
click_on "help/+"
wait_for '^window.text_scale=1\.[0-9]'
click_on "help/close"
wait_for '^window.help=false$'
see_picture large.png
holds "$(convert large.png -format '%[fx:standard_deviation]' info:) > 0.05" || fail "nothing is drawn after the text size changed"
press ctrl+0
wait_for '^window.text_scale=1$'
echo "passed"
