#!/usr/bin/env bash
# How long the window lets people wait: a scripted session of mouse moves, keys, drags and scrolling on a large scene at
# 1920x1080 on the software renderer, by the CPU and by the GLSL passes, with other builders and with a slider of the tree.
# Writes the time from sending every event to the frame that answers it; an event that was never answered has no time. Ends
# with 1 where less than 95 % of the events that need no other tree are answered within 100 ms.
#
#   tests/bench/responsiveness.sh [kdscope] [output.csv] [scene] [n: one of n events alone, to see that it works]
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
KDSCOPE=$(realpath -- "${1:-$root/build/release/kdscope}")
output=$(realpath -m -- "${2:-$root/docs/responsiveness.csv}")
scene=${3:-scatter:100000}
part=${4:-1}
SCREEN=1920x1080
export KDSCOPE

if [[ -z ${KD_INSIDE_XVFB:-} ]]; then
    export KD_INSIDE_XVFB=1
    exec xvfb-run -a -s "-screen 0 ${SCREEN}x24" bash "$0" "$KDSCOPE" "$output" "$scene" "$part"
fi

folder=$(mktemp -d) && cd "$folder" || exit 1
source "$root/tests/e2e/window_helpers.bash"
trap 'stop_window; rm -rf "$folder"' EXIT
export KDSCOPE_EVENT_LOG=$PWD/events.csv
start_window "$scene"
xdotool windowsize "$window" "${SCREEN%x*}" "${SCREEN#*x}"
sleep 4

# One xdotool for all of the session: a process for each event would add the time that it takes to start.
coproc XDOTOOL { exec xdotool -; }
# send EVENT COMMANDS...: one event of the kind that the window's log calls so, and the time before it.
send() {
    local event=$1
    shift
    echo "${EPOCHREALTIME//[.,]/},$event" >>sent.csv
    echo "$*" >&"${XDOTOOL[1]}"
}
move() { send move mousemove_relative -- "$@"; }
key() { send key keydown --delay 0 "$1"; send key keyup --delay 0 "$1"; }
# Not xdotool's click, which rests for a tenth of a second after it: events would wait there, not in the window.
notch() { send scroll mousedown "$1"; echo "mouseup $1" >&"${XDOTOOL[1]}"; }

# Ends a part of the session, whose events "keeps" the tree, or need another "tree": kind NAME keeps|tree [seconds].
touch sent.csv
marks=()
kind() {
    sleep "${3:-1}"
    marks+=("$(wc -l <sent.csv),$1,$2")
}
# The pace of a person: an event every 60 ms while something is dragged, slower otherwise.
times() { seq $((($1 + part - 1) / part)); }
sweep() { for _ in $(times "$1"); do move "$2" "$3"; sleep 0.06; done; }
drag() { send button mousedown 1; sweep "$@"; send button mouseup 1; sleep 0.6; }
keys() {
    local n=0 key
    for key in "$@"; do ((n++ % part == 0)) && key "$key" && sleep 0.4; done
}
scroll() { for _ in $(times "$2"); do notch "$1"; sleep 0.06; done; }

# What came before belongs to the opening of the window. The mouse is brought where it may move without leaving it.
xdotool mousemove 700 400
sleep 2
before=$(cut -d, -f1 "$KDSCOPE_EVENT_LOG" | sort -n | tail -1)
sweep 30 12 6
kind "mouse over the picture" keeps
keys h h s bracketright bracketright s c g g l n d h m
kind "keys of the map" keeps
drag 40 8 3
send key keydown shift; drag 20 -6 4; send key keyup shift
drag 20 -8 -3
kind "drags on the CPU" keeps
scroll 4 20
scroll 5 20
kind "scrolling on the CPU" keeps
keys t t t r p Right Down Escape
kind "keys of traversal and pixel" keeps
key v
kind "V: CPU to GLSL" keeps 5
drag 20 8 3
scroll 4 8
scroll 5 8
kind "drags and scrolls by GLSL" keeps
key v
kind "V: GLSL to CPU" keeps 2
for _ in $(times 4); do key b; sleep 1.5; done
kind "B: builders" tree 3
read -r -a at < <(place "TREE/intersection cost (t_i)")
[[ ${#at[@]} == 4 ]] || fail "the slider is not to be seen"
send move mousemove $((${at[0]%.*} + ${at[2]%.*} / 3)) $((${at[1]%.*} + ${at[3]%.*} / 2))
sleep 0.3
drag 16 3 0
kind "slider of the tree" tree 5

stop_window  # events still unanswered are written now
# The window takes the events of one kind in the order in which they were sent. Written: number, kind, when it was sent and
# taken and answered, in ms since the first was sent, and the time from sending to the answer.
sort -t, -n "$KDSCOPE_EVENT_LOG" | awk -F, -v before="$before" '
    BEGIN { print "event,kind,t_sent_ms,t_taken_ms,t_frame_ms,latency_ms" }
    NR == FNR { event[++sent] = $2; at[sent] = $1 / 1000; next }
    $1 + 0 > before + 0 && $2 != "resize" { taken[$2, ++count[$2]] = $3; answered[$2, count[$2]] = $4 }
    END {
        for (i = 1; i <= sent; i++) {
            k = event[i]
            n = ++seen[k]
            if (!((k, n) in taken)) { print "sent " k " number " n ", which the window never took" >"/dev/stderr"; exit 2 }
            t = taken[k, n]
            if (t < at[i] - 1) { print "the window took " k " number " n " before it was sent" >"/dev/stderr"; exit 2 }
            f = answered[k, n]
            printf "%d,%s,%.2f,%.2f,%s\n", i, k, at[i] - at[1], t - at[1], f == "" ? "," : sprintf("%.2f,%.2f", f - at[1], f - at[i])
        }
        for (k in count)
            if (count[k] != seen[k]) { print "the window took " count[k] " of " k ", sent were " seen[k] + 0 >"/dev/stderr"; exit 2 }
    }' sent.csv - >joined.csv || fail "what was sent is not what was taken"
cp joined.csv "$output"
# A row for each part, then all. Without a latency an event counts as the slowest of all.
printf '%s\n' "${marks[@]}" | awk -F, '
    function ms(t) { return t >= 1e9 ? "never" : sprintf("%.1f ms", t) }
    function row(name, n, v,    i, j, t, within, never) {
        for (i = 2; i <= n; i++) { t = v[i]; for (j = i - 1; j >= 1 && v[j] > t; j--) v[j + 1] = v[j]; v[j + 1] = t }
        for (i = 1; i <= n; i++) { if (v[i] <= 100) within++; if (v[i] >= 1e9) never++ }
        if (n > 0) printf "%-28s %6d %10s %16s %17.1f %% %6d\n", name, n, ms(v[int((n + 1) / 2)]), ms(v[int(0.95 * n + 0.5)]), 100 * within / n, never
        return n > 0 ? within / n : 1
    }
    NR == FNR { last[NR] = $1; name[NR] = $2; by[NR] = $3; parts = NR; next }
    FNR > 1 {
        for (p = 1; p < parts && $1 > last[p]; p++) continue
        t = $6 == "" ? 1e9 : $6
        of[p, ++n[p]] = t
        all[++count] = t
        if (by[p] != "tree") held[++held_count] = t
    }
    END {
        if (count == 0) { print "no events"; exit 1 }
        printf "%-28s %6s %10s %16s %19s %6s\n", "kind", "events", "median", "95th percentile", "within 100 ms", "never"
        for (p = 1; p <= parts; p++) {
            delete v
            for (i = 1; i <= n[p]; i++) v[i] = of[p, i]
            row(name[p], n[p], v)
        }
        row("all", count, all)
        exit row("all that keep the tree", held_count, held) < 0.95
    }' - "$output"
