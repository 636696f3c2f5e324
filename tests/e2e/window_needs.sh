#!/usr/bin/env bash
# NEEDS: lists what the scene needs; a feature is put back and left out again, the picture stays; what it saves is measured.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window cornell
click_on "TIME/measure while idle"  # its programs count nothing, and are others
press x
wait_for '^bottom=NEEDS$'
for label in measure "leave all out" reflections textures normals; do
    [[ -n $(place "NEEDS/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
holds "$(value left_out.0 | grep -c 'later bounces')" || fail "the first thing left out is $(value left_out.0)"

move_to 640 712  # no tooltip over the picture
see_picture without.png
click_on "NEEDS/textures"
wait_for '^settings.forced.0=textures$'
move_to 640 712
see_picture with.png
[[ $(difference without.png with.png) == 0 ]] || fail "the picture changed by $(difference without.png with.png)"
[[ $(value left_out.1) != texture* ]] || fail "still left out: $(value left_out.1)"
click_on "NEEDS/leave all out"
wait_for '^settings.forced=\[\]$'

# On the GPU other programs are made, once.
press v
wait_for '^settings.tracer=gl-fragment$'
made=$(value compiled)
holds "$made > 0" || fail "no program was compiled"
click_on "NEEDS/textures"
wait_for '^settings.forced.0=textures$'
holds "$(value compiled) > $made" || fail "no program was made for textures"
made=$(value compiled)
click_on "NEEDS/textures"
wait_for '^settings.forced=\[\]$'
click_on "NEEDS/textures"
wait_for '^settings.forced.0=textures$'
[[ $(value compiled) == "$made" ]] || fail "programs were made twice: $(value compiled), before $made"
click_on "NEEDS/textures"
wait_for '^settings.forced=\[\]$'

# What is left out of the CPU's work, measured.
press v
wait_for '^settings.tracer=cpu$'
click_on "NEEDS/measure"
wait_for '^needs.saved_ms.textures=' 120
wait_for '^needs.active=false$'
[[ -n $(value needs.saved_ms.normals) ]] || fail "normals were not timed"
[[ -z $(value needs.saved_ms.spot-lights) ]] || fail "the CPU has no spot lights to leave out"
press x
wait_for '^bottom=TIME$'
