#!/usr/bin/env bash
# 1920x1080: the first window suits the screen, no two controls overlap, everything is to be seen; the locked range stays
# when the traversal changes; the legend is dragged and hidden; the size of text is changed and remembered.
SCREEN=1920x1080
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
read -r -a top <<<"$(place 'top/?')"
holds "${top[0]} > 1500 && ${top[0]} < 1920" || fail "the first window is no wider than ${top[0]}"
xdotool windowsize "$window" 1920 1080
wait_for '^frame.width=1[34]'

for label in SCENE TREE TRACING VIEW PIXEL EXPORT "VIEW/map" "VIEW/range" "VIEW/splits to depth" "VIEW/logarithmic" \
    "TRACING/traversal" "PIXEL/release pixel" "EXPORT/JSON" "TIME/measure while idle" legend; do
    [[ -n $(place "$label") ]] || fail "'$label' is not to be seen"
done
# Pairs of controls that share pixels.
overlaps() {
    state | sed -n 's/^places\.\(.*\)\.\([0-3]\)=\(.*\)$/\1|\2|\3/p' | awk -F'|' '
        { at[$1, $2] = $3; if (!($1 in seen)) { seen[$1]; name[n++] = $1 } }
        END {
            for (i = 0; i < n; i++)
                for (j = i + 1; j < n; j++) {
                    a = name[i]; b = name[j]
                    if (at[a, 0] + 0.5 < at[b, 0] + at[b, 2] && at[b, 0] + 0.5 < at[a, 0] + at[a, 2] &&
                        at[a, 1] + 0.5 < at[b, 1] + at[b, 3] && at[b, 1] + 0.5 < at[a, 1] + at[a, 3]) print a " / " b
                }
        }'
}
[[ -z $(overlaps) ]] || fail "overlapping: $(overlaps)"
left=$(value picture_area.0) width=$(value picture_area.2)
holds "$width >= 0.6 * 1920" || fail "the picture has only $width of 1920 pixels"
import -window root screen.png
for part in "${left%.*}x800+0+40" "200x400+1710+40" "600x90+300+860"; do
    spread=$(convert screen.png -crop "$part" +repage -colorspace Gray -format '%[fx:standard_deviation]' info:)
    holds "$spread > 0.03" || fail "nothing is written at $part"
done

press l
wait_for '^settings.view.map.range.1='
top_of_range=$(value settings.view.map.range.1)
press t
wait_for '^settings.traversal=restart$'
wait_for '^counters.primary.restarts=[1-9]'
[[ $(value settings.view.map.range.1) == "$top_of_range" ]] || fail "the locked range moved"
press n
wait_for '^settings.view.map.range=automatic$'

read -r -a before <<<"$(place legend)"
point_at legend && hold && hover 100 100 && let_go
wait_for '^window.legend_corner=0$'
read -r -a after <<<"$(place legend)"
holds "${after[0]} < ${before[0]} - 500 && ${after[1]} < ${before[1]} - 200" || fail "the legend stayed"
[[ $(value pinned) == null ]] || fail "dragging the legend pinned a pixel"
press k
wait_for '^window.legend=false$'
[[ -z $(place legend) ]] || fail "the legend is still there"

press ctrl+plus
press ctrl+plus
wait_for '^window.text_scale=1.2$'
read -r -a large <<<"$(place 'top/?')"
holds "${large[3]} > 1.15 * ${top[3]}" || fail "nothing grew: ${large[3]}, ${top[3]}"
[[ -z $(overlaps) ]] || fail "overlapping at 120 %: $(overlaps)"
stop_window
start_window ball:300
wait_for '^window.text_scale=1.2$'
wait_for '^window.legend_corner=0$'
press ctrl+0
wait_for '^window.text_scale=1(\.0)?$'
echo "passed"
