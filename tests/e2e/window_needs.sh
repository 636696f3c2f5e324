#!/usr/bin/env bash
# NEEDS: lists what the scene needs; a feature is put back and left out again, the picture stays; what it saves is measured.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window cornell
click_on "TIME/measure while idle"  # its programs count nothing, and are others
press x
wait_for '^bottom=NEEDS$'
for label in measure "leave all out" reflections shadows; do # what follows is scrolled to
    [[ -n $(place "NEEDS/$label") ]] || fail "'$label' is not to be seen at $SCREEN"
done
# The border above it is dragged until the list has room for textures too.
border=$(value picture_area.1)
border=$((${border%.*} + $(value picture_area.3 | cut -d. -f1) + 2))
move_to 600 "$border" && hold && move_by 5 0 -20 && let_go
[[ -n $(place NEEDS/textures) ]] || fail "'textures' is not to be seen in a higher strip"
left_out() { state | sed -n 's/^left_out\.[0-9]*=//p'; }
left_out | grep -q '^later bounces: ' || fail "left out: $(left_out)"
left_out | grep -q '^texture fetch: ' || fail "left out: $(left_out)"
left_out | grep -q '^spot lights: ' && fail "the CPU is told what only the GPU leaves out: $(left_out)"

move_to 640 712  # no tooltip over the picture
see_picture without.png
click_on "NEEDS/textures"
wait_for '^settings.forced.0=textures$'
move_to 640 712
see_picture with.png
[[ $(difference without.png with.png) == 0 ]] || fail "the picture changed by $(difference without.png with.png)"
left_out | grep -q '^texture fetch: ' && fail "still left out: $(left_out)"
click_on "NEEDS/leave all out"
wait_for '^settings.forced=\[\]$'

# On the GPU other programs are made, once.
press v
wait_for '^settings.tracer=gl-fragment$'
left_out | grep -q '^spot lights: ' || fail "the GPU leaves out: $(left_out)"
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
move_to 600 $((border - 100)) && hold && move_by 5 0 20 && let_go  # PIXEL has its rows again

# What the scene cannot have is not offered: rays of mirrors, until their passes are put back.
choose "top/scene" rooms
wait_for '^settings.scene=rooms$'
[[ -z $(place PIXEL/reflection) && -n $(place PIXEL/shadow) ]] || fail "PIXEL has rows of reflections"
choose "PIXEL/rays" reflection
press Escape
[[ $(value pixel_rays) == primary ]] || fail "rays that are not there were chosen"
press x
click_on "NEEDS/reflections"
wait_for '^settings.forced.0=reflections$'
[[ -n $(place PIXEL/reflection) ]] || fail "no row of the reflections put back"
choose "PIXEL/rays" reflection
wait_for '^pixel_rays=reflection$'
echo "passed"
