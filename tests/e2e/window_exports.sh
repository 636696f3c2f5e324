#!/usr/bin/env bash
# EXPORT: every button writes its kind of file, into the folder that was typed, under names that count up.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

mkdir -p home/figures
export HOME=$PWD/home
start_window ball:300
width=$(value frame.width) height=$(value frame.height)
pixels=$((width * height))
click_on "EXPORT/folder"
press ctrl+a
xdotool type --delay 0 '~/figures'
press Return

export_as() {
    click_on "EXPORT/$1"
    wait_for "^last_export=~/figures/$2$"
    [[ -s home/figures/$2 ]] || fail "$2 is not there"
}
size_of() { convert "home/figures/$1" -format '%wx%h' info:; }

export_as figure kdscope-1.png
holds "$(convert home/figures/kdscope-1.png -format '%w' info:) > $width" || fail "the figure has no room for a legend"
export_as picture kdscope-2.png
[[ $(size_of kdscope-2.png) == "${width}x$height" ]] || fail "the picture is $(size_of kdscope-2.png)"
export_as window kdscope-3.png
[[ $(size_of kdscope-3.png) == "$SCREEN" ]] || fail "the window is $(size_of kdscope-3.png)"
left=$(value picture_area.0) top=$(value picture_area.1)
# Below what the window says at the picture's top.
convert home/figures/kdscope-3.png -crop "300x200+${left%.*}+$((${top%.*} + height - 250))" +repage window-part.png
convert home/figures/kdscope-2.png -crop "300x200+0+$((height - 250))" +repage picture-part.png
holds "$(difference window-part.png picture-part.png) < 0.02" || fail "the window's picture is not the picture"
export_as CSV kdscope-4.csv
grep -q '^# .*threads' home/figures/kdscope-4.csv || fail "the table does not say what it was measured on"
[[ $(grep -vc '^#' home/figures/kdscope-4.csv) -eq $((pixels + 1)) ]] || fail "not a row per pixel"
sum=$(grep -v '^#' home/figures/kdscope-4.csv | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "primary_triangle_tests") c = i; next } { s += $c } END { print s }')
[[ $sum == "$(value counters.primary.triangle_tests)" ]] || fail "the table sums to $sum tests"
export_as JSON kdscope-5.json
grep -q "\"triangle_tests\": $sum" home/figures/kdscope-5.json || fail "the summary has another sum"
# The same keys and numbers as the command's, but for times, the minute, and how busy the machine was then.
"$KDSCOPE" render ball:300 --size "${width}x$height" --map nodes --opacity 0.5 -o r.png --json r.json >/dev/null
lines_of() { KDSCOPE_STATE_FILE=$1 state | grep -vE '^(ms\.|measured_on\.(date|load)=)'; }
lines_of r.json >command.txt && lines_of home/figures/kdscope-5.json >window.txt
cmp -s command.txt window.txt || fail "the summaries differ: $(diff command.txt window.txt)"
# The caption also stands in the file as text, uncompressed.
grep -aq 'Description.*(steady clock)' home/figures/kdscope-1.png || fail "the caption names no clock"

# A folder that is not there is made, with those above it, and that is told; one that cannot be made is an error.
click_on "EXPORT/folder"
press ctrl+a
xdotool type --delay 0 '~/new/deep/folder'
press Return
[[ ! -e home/new ]] || fail "a folder was made before anything is written"
click_on "EXPORT/CSV"
wait_for '^messages.*=made the folder ~/new/deep/folder; wrote ~/new/deep/folder/kdscope-1.csv'
[[ $(grep -vc '^#' home/new/deep/folder/kdscope-1.csv) -eq $((pixels + 1)) ]] || fail "not a row per pixel"
click_on "EXPORT/folder"
press ctrl+a
xdotool type --delay 0 '~/new/deep/folder/kdscope-1.csv/x'
press Return
click_on "EXPORT/CSV"
wait_for '^messages.*=export: cannot make the folder'
echo "passed"
