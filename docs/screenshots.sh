#!/usr/bin/env bash
# Makes the pictures of docs/window.md: the window at 1280x720 on a virtual screen, each part of it in use.
#
#   docs/screenshots.sh [kdscope] [folder]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
kdscope=${1:-$root/build/release/kdscope}
folder=${2:-$root/docs/images}

if [[ -z ${KD_INSIDE_XVFB:-} ]]; then
    export KD_INSIDE_XVFB=1
    exec xvfb-run -a -s "-screen 0 1280x720x24" bash "$0" "$kdscope" "$folder"
fi

scratch=$(mktemp -d)
mkdir -p "$folder"
cd /tmp  # stands in the export panel
export XDG_CONFIG_HOME=$scratch KDSCOPE_STATE_FILE=$scratch/state.json
pid=
trap '[[ -n $pid ]] && kill $pid 2>/dev/null; rm -rf "$scratch"' EXIT

open() {
    rm -f "$KDSCOPE_STATE_FILE"
    "$kdscope" "$@" &
    pid=$!
    until [[ -f $KDSCOPE_STATE_FILE ]]; do sleep 0.1; done
    window=$(xdotool search --name '^kdscope$' | tail -1)
    xdotool windowmove "$window" 0 0 windowsize "$window" 1280 720 windowfocus "$window" 2>/dev/null || true
    sleep 1.5
}
close() {
    kill "$pid" && wait "$pid" || true
    pid=
}
press() {
    for key in "$@"; do
        xdotool key "$key"
        sleep 0.5
    done
}
shoot() {
    sleep "${2:-2}"
    import -window root -strip "$folder/$1.png"
    echo "$folder/$1.png"
}

open ball:9000
xdotool mousemove 560 330
shoot window 14  # time for some rounds of CPU against GPU

press t
xdotool click 1
shoot restart 10
press d
shoot divergence
press h h s bracketleft
shoot splits
press Escape F1
shoot help
press Escape s v
shoot gpu 12
close

open rooms --traversal backtrack
press s
xdotool mousemove 700 250 click 1
shoot rooms 8
press u
shoot picture-alone 4
close
