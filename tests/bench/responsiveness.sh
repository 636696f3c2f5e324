#!/usr/bin/env bash
# How long the window lets people wait: a scripted session of mouse moves, keys, drags and scrolling on a large scene at
# 1920x1080 on the software renderer, by the CPU and by the GLSL passes, with other programs, other builders and a slider of the tree.
# Writes the time from sending every event to the first frame that follows it (what was moved or pressed shows it) and to
# the frame with its picture; an event that never had one has no time. Ends with 1 where less than 95 % of all events are
# followed by a frame within 100 ms, or less than 95 % of those that need neither another tree nor other programs have their
# picture by then. Shaders are compiled anew, whatever was compiled before.
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
export KDSCOPE_EVENT_LOG=$PWD/events.csv MESA_SHADER_CACHE_DISABLE=true
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

# Ends a part of the session, whose events keep tree and programs, or need others: kind NAME keeps|makes [seconds].
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
# centre PLACE: of what the window draws there, once it rests and says so.
centre() {
    local end=$((SECONDS + 60))
    until [[ -n $(place "$1") ]]; do ((SECONDS < end)) && sleep 0.2 || return 1; done
    place "$1" | awk '{ printf "%d %d\n", $1 + $3 / 2, $2 + $4 / 2 }'
}
# press X Y: of a switch.
press() { send move mousemove "$@"; sleep 0.2; send button mousedown 1; sleep 0.1; send button mouseup 1; }
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
kind "V: CPU to GLSL" makes 5
drag 20 8 3
scroll 4 8
scroll 5 8
kind "drags and scrolls by GLSL" keeps
key x
sleep 2
for _ in $(times 2); do
    for feature in many-lights textures normals; do
        read -r -a at < <(centre "NEEDS/$feature") || fail "the switch of $feature is not to be seen"
        press "${at[@]}"
        sleep 3
    done
done
key x
kind "X: features put back" makes
key v
kind "V: GLSL to CPU" keeps 2
for _ in $(times 4); do key b; sleep 1.5; done
kind "B: builders" makes 3
read -r -a at < <(place "TREE/intersection cost (t_i)")
[[ ${#at[@]} == 4 ]] || fail "the slider is not to be seen"
send move mousemove $((${at[0]%.*} + ${at[2]%.*} / 3)) $((${at[1]%.*} + ${at[3]%.*} / 2))
sleep 0.3
drag 16 3 0
kind "slider of the tree" makes 5

stop_window  # events still unanswered are written now
# The window takes the events of one kind in the order in which they were sent. Written: number, kind, when it was sent and
# taken and answered, in ms since the first was sent, and the time from sending to the answer.
sort -t, -n "$KDSCOPE_EVENT_LOG" | awk -F, -v before="$before" '
    function since(t, from) { return t == "" ? "" : sprintf("%.2f", t - from) }
    BEGIN { print "event,kind,t_sent_ms,t_taken_ms,t_first_frame_ms,t_frame_ms,first_frame_after_ms,latency_ms" }
    NR == FNR { event[++sent] = $2; at[sent] = $1 / 1000; next }
    $1 + 0 > before + 0 && $2 != "resize" { taken[$2, ++count[$2]] = $3; first[$2, count[$2]] = $4; answered[$2, count[$2]] = $5 }
    END {
        for (i = 1; i <= sent; i++) {
            k = event[i]
            n = ++seen[k]
            if (!((k, n) in taken)) { print "sent " k " number " n ", which the window never took" >"/dev/stderr"; exit 2 }
            t = taken[k, n]
            if (t < at[i] - 1) { print "the window took " k " number " n " before it was sent" >"/dev/stderr"; exit 2 }
            s = first[k, n]
            f = answered[k, n]
            printf "%d,%s,%.2f,%.2f,%s,%s,%s,%s\n", i, k, at[i] - at[1], t - at[1], since(s, at[1]), since(f, at[1]), since(s, at[i]), since(f, at[i])
        }
        for (k in count)
            if (count[k] != seen[k]) { print "the window took " count[k] " of " k ", sent were " seen[k] + 0 >"/dev/stderr"; exit 2 }
    }' sent.csv - >joined.csv || fail "what was sent is not what was taken"
cp joined.csv "$output"
# A row for each part, then all: until the picture, and the share that the first frame followed within 100 ms. Without a
# picture an event counts as the slowest of all.
printf '%s\n' "${marks[@]}" | awk -F, '
    function ms(t) { return t >= 1e9 ? "never" : sprintf("%.1f ms", t) }
    function add(part, first, t) { of[part, ++n[part]] = t; quick[part] += first != "" && first + 0 <= 100 }
    function row(part, name,    i, j, t, v, within, never, count) {
        if ((count = n[part]) == 0) return
        for (i = 1; i <= count; i++) { t = of[part, i]; for (j = i - 1; j >= 1 && v[j] > t; j--) v[j + 1] = v[j]; v[j + 1] = t }
        for (i = 1; i <= count; i++) { if (v[i] <= 100) within++; if (v[i] >= 1e9) never++ }
        shown[part] = within / count
        printf "%-26s %6d %15.1f %% %10s %10s %15.1f %% %6d\n", name, count, 100 * quick[part] / count, ms(v[int((count + 1) / 2)]),
            ms(v[int(0.95 * count + 0.5)]), 100 * shown[part], never
    }
    NR == FNR { last[NR] = $1; name[NR] = $2; by[NR] = $3; parts = NR; next }
    FNR > 1 {
        for (p = 1; p < parts && $1 > last[p]; p++) continue
        t = $8 == "" ? 1e9 : $8
        add(p, $7, t)
        add("all", $7, t)
        if (by[p] == "keeps") add("held", $7, t)
    }
    END {
        if (n["all"] == 0) { print "no events"; exit 1 }
        printf "%-26s %6s %17s %10s %10s %17s %6s\n", "", "", "first frame", "picture", "95th", "picture", ""
        printf "%-26s %6s %17s %10s %10s %17s %6s\n", "kind", "events", "within 100 ms", "median", "percentile", "within 100 ms", "never"
        for (p = 1; p <= parts; p++) row(p, name[p])
        row("all", "all")
        row("held", "all that keep both")
        exit quick["all"] / n["all"] < 0.95 || shown["held"] < 0.95
    }' - "$output"
