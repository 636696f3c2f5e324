#!/usr/bin/env bash
# A million triangles at 1024x1024 with one bounce, as the paper's arithmetic has them (its section 5): loaded, built,
# rendered and mapped; in the window too, which answers the mouse meanwhile. Times and peak memory are printed.
SCREEN=1920x1200
# shellcheck source=tests/e2e/window_helpers.bash
source "$(dirname -- "${BASH_SOURCE[0]}")/../e2e/window_helpers.bash"

# Peak memory of a process in MB, of its proc/PID/status.
peak_of() { awk '/^VmHWM/ { printf "%.0f", $2 / 1024 }' "$1"; }
now() { date +%s.%N; }

begin=$(now)
"$KDSCOPE" render ball:1000000 --size 1024x1024 --map nodes -o map.png >log.txt 2>&1 &
render_pid=$!
peak=0
while kill -0 $render_pid 2>/dev/null; do
    [[ -r /proc/$render_pid/status ]] && seen=$(peak_of /proc/$render_pid/status) && [[ -n $seen ]] && peak=$seen
    sleep 0.05
done
wait $render_pid || fail "render"
echo "render: $(awk "BEGIN { printf \"%.1f\", $(now) - $begin }") s, $peak MB at most"
((peak < 2048)) || fail "$peak MB for a million triangles"
[[ $(identify -format '%w' map.png) -ge 1024 ]] || fail "the map's size"

begin=$(now)
start_window ball:1000000
echo "window: first picture after $(awk "BEGIN { printf \"%.1f\", $(now) - $begin }") s"
[[ $(value tree.nodes) -gt 500000 ]] || fail "$(value tree.nodes) nodes"
press b
wait_for '^building=true$'
longest=0 answers=0
while [[ $(value building) == true ]]; do
    before=$(now)
    move_to $((700 + answers % 50 * 4)) 500
    longest=$(awk "BEGIN { t = $(now) - $before; print (t > $longest ? t : $longest) }")
    answers=$((answers + 1))
done
wait_for '^frame.scale=1$' 120
echo "window: $answers mouse moves answered during a build, the slowest after $longest s;" \
    "$(peak_of "/proc/$window_pid/status") MB at most"
((answers >= 3)) || fail "the window hardly answered"
holds "$longest < 2 * $PATIENCE" || fail "an answer took $longest s"
stop_window
echo "passed"
