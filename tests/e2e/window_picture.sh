#!/usr/bin/env bash
# The screen: the picture is not blank, the heatmap has its colours, panels come and go, exported files do not overwrite.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:1000
see_picture heat.png
deviation=$(convert heat.png -colorspace Gray -format '%[fx:standard_deviation]' info:)
holds "$deviation > 0.03" || fail "the picture is blank: deviation $deviation"

# Full opacity would be viridis itself; half of it still leaves its yellow, which nothing in the scene has.
yellow=$(convert heat.png -fx '(r > 0.55 && g > 0.5 && b < 0.4) ? 1 : 0' -format '%[fx:mean]' info:)
holds "$yellow > 0.001" || fail "no hot pixels: $yellow"
press h
wait_for '^settings.view.map.shown=false$'
see_picture beauty.png
cold=$(convert beauty.png -fx '(r > 0.55 && g > 0.5 && b < 0.4) ? 1 : 0' -format '%[fx:mean]' info:)
holds "$cold < $yellow / 2" || fail "hot pixels without a map: $cold"
press h
wait_for '^settings.view.map.shown=true$'

# Without panels the picture takes the whole width.
narrow=$(value frame.width)
press u
wait_for '^window.panels=false$'
wait_for '^frame.width=1280$'
press u
wait_for "^frame.width=$narrow$"

# Exports count up.
press F12
wait_for '^last_export=.*kdscope-1.png'
cp kdscope-1.png first.png
press F12
wait_for '^last_export=.*kdscope-2.png'
cmp -s kdscope-1.png first.png || fail "the first export was overwritten"
[[ $(convert kdscope-1.png -format %w info:) -gt $narrow ]] || fail "the figure has no legend beside it"

# Another size of the window.
xdotool windowsize "$window" 1000 640
wait_for '^frame.width=[4-6][0-9][0-9]$'
[[ $(value frame.width) == "$(value settings.width)" ]] || fail "frame and session differ in size"
[[ ! -s log.txt ]] || fail "the window said something"
echo "passed"
