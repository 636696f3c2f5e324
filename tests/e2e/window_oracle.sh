#!/usr/bin/env bash
# The oracle's map in the window: counts of wrong pixels under the published rules, from one to the next, none under the
# robust rules, shadow rays refused.
SCREEN=1060x1440  # high enough for all of TRACING
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window rooms --rules as-published
state | grep -q '^oracle\.' && fail "compared before anyone asked"
click_on "top/Oracle"
wait_for '^settings.view.map.name=oracle$'
wait_for '^oracle.wrong=[1-9]'
wrong=$(value oracle.wrong)
missed=$(value oracle.missed)
compared=$(value oracle.compared)
((compared == $(value frame.width) * $(value frame.height))) || fail "$compared pixels were compared"
((missed > 0 && missed <= wrong)) || fail "$missed missed of $wrong wrong"

# The same counts as the command line's.
size="$(value frame.width)x$(value frame.height)"
"$KDSCOPE" render rooms --rules as-published --map oracle --size "$size" -o o.png --json o.json >/dev/null || fail "render failed"
grep -q "\"wrong\": $wrong," o.json || fail "render counts $(grep '"wrong"' o.json), the window $wrong"

# W pins a wrong pixel; again one elsewhere; Shift W the one before.
holds "$(value wrong_places) > 3 && $(value wrong_places) < $wrong / 2" || fail "$(value wrong_places) places of $wrong wrong pixels"
press w
wait_for '^pinned.oracle.verdict=(missed|false hit|wrong triangle|t off)$'
first_x=$(value pinned.x) first_y=$(value pinned.y)
for _ in 1 2 3; do
    x=$(value pinned.x) y=$(value pinned.y)
    click_on "PIXEL/next"
    dx=$(($(value pinned.x) - x)) dy=$(($(value pinned.y) - y))
    ((${dx#-} > 8 || ${dy#-} > 8)) || fail "the next place is $dx, $dy away"
done
for _ in 1 2 3; do press shift+w; done
[[ "$(value pinned.x),$(value pinned.y)" == "$first_x,$first_y" ]] || fail "not back at $first_x,$first_y"
[[ $(value pinned.oracle.triangle) != "$(value pinned.primary.triangle)" ]] || fail "the verdict names the triangle found"

# A click on a wrong pixel pins it, and PIXEL names its verdict, in the colour of errors.
verdict=$(value pinned.oracle.verdict)
press Escape
wait_for '^pinned=null$'
hover "$first_x" "$first_y"
wait_for "^hovered.x=$first_x$" && wait_for "^hovered.y=$first_y$"
hold && let_go
wait_for "^pinned.x=$first_x$" && wait_for "^pinned.y=$first_y$"
[[ $(value pinned.oracle.verdict) == "$verdict" ]] || fail "clicked on, it is '$(value pinned.oracle.verdict)', with W '$verdict'"
# Share of a row of PIXEL in that colour.
error_share() {
    local at
    read -r -a at < <(place "PIXEL/$1")
    sleep 0.3
    import -window root -crop "${at[2]%.*}x${at[3]%.*}+${at[0]%.*}+${at[1]%.*}" +repage png:- |
        convert png:- -fuzz 15% -fill black +opaque '#d55e00' -format '%[fx:mean]' info:
}
holds "$(error_share verdict) > 0.005" || fail "PIXEL does not name the verdict: $(error_share verdict)"
holds "$(error_share "exact t") == 0" || fail "another row of PIXEL has the colour of errors"

# A camera that moves is compared anew.
hover 200 150
hold && move_by 4 8 3 && let_go
press Escape
wait_for '^oracle.compared=[1-9]'
press r
wait_for "^oracle.wrong=$wrong$"

# Nothing is wrong under the robust rules.
choose "TRACING/rules" robust
wait_for '^oracle.wrong=0$'
press w
[[ $(value pinned) == null ]] || fail "a pixel was pinned, and none is wrong"

# Shadow rays have no nearest hit.
choose "VIEW/rays" shadow
wait_for 'choose primary or reflection rays'
wait_for '^settings.view.map.rays=primary$'
echo "passed"
