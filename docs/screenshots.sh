#!/usr/bin/env bash
# Makes the pictures of docs/window.md: the window at 1280x720, and every panel in use at 1920x1080.
#
#   docs/screenshots.sh [kdscope] [folder] [parts, such as "small_oracle panels_of_time": else all]
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
KDSCOPE=$(realpath -- "${1:-$root/build/release/kdscope}")
folder=$(realpath -m -- "${2:-$root/docs/images}")
parts=${3:-}
export KDSCOPE

if [[ -z ${KD_INSIDE_XVFB:-} ]]; then
    mkdir -p "$folder"
    for SCREEN in 1280x720 1920x1080; do
        export KD_INSIDE_XVFB=1 SCREEN
        xvfb-run -a -s "-screen 0 ${SCREEN}x24" bash "$0" "$KDSCOPE" "$folder" "$parts" || exit 1
    done
    exit 0
fi

scratch=$(mktemp -d) && cd "$scratch" || exit 1
source "$root/tests/e2e/window_helpers.bash"
trap 'stop_window; rm -rf "$scratch"' EXIT
export KDSCOPE_EXIT_AFTER_S=600 HOME=$PWD/home
mkdir -p home/figures && cd home/figures || exit 1  # the folder that EXPORT shows

open() {
    start_window "$@"
    xdotool windowsize "$window" "${SCREEN%x*}" "${SCREEN#*x}"
    sleep 1.5
}
press_all() {
    for key in "$@"; do
        press "$key"
        sleep 0.5
    done
}
# The large pictures are of few colours, which makes them small files.
shoot() {
    sleep "${2:-2}"
    import -window root shot.png
    if [[ $SCREEN == 1280x720 ]]; then
        convert shot.png -strip "$folder/$1.png"
    else
        convert shot.png -strip +dither -colors 255 "PNG8:$folder/$1.png"
    fi
    rm shot.png
    echo "$folder/$1.png"
}
# Clicks on what makes other things move, each time until the window rests and says where they are.
open_or_close() {
    for label in "$@"; do
        sleep 3
        click_on "$label"
    done
    sleep 3
}
# Until TIME says who is faster, for the frame that is shown.
decided() {
    wait_for '^duel.outdated=false$' 120
    wait_for '^duel.decided=true$' 120
}

small_tour() {
    open ball:9000
    xdotool mousemove 560 330
    decided
    shoot window
    press_all t
    xdotool click 1
    sleep 1
    decided
    shoot restart
    press_all d
    decided
    shoot divergence
    press_all h h s bracketleft
    shoot splits
    press_all Escape F1
    shoot help
    press_all Escape s v
    sleep 1
    decided
    shoot gpu
    stop_window
}
small_stability() {
    open ball:9000 --rules as-published
    press_all y
    click_on "STABILITY/T16"
    click_on "STABILITY/sweep"
    wait_for '^stability.sweep_complete=true$' 280
    drag_slider "STABILITY/scene at" 0.05 0.5
    hover 600 20
    shoot stability-sweep
    stop_window
}
small_needs() {
    open rooms --tracer gl-fragment
    press_all x
    click_on "NEEDS/measure"
    wait_for '^needs.saved_ms.textures=' 280
    wait_for '^needs.active=false$'
    click_on "NEEDS/reflections"
    wait_for '^settings.forced.0=reflections$'
    hover 600 20
    shoot needs
    stop_window
}
small_motion() {
    open sheet:20000 --builder exact
    press_all shift+m
    choose "MOTION/schedule" on-demand
    press_all space
    wait_for '^motion.frames=32$' 120
    press_all space
    choose "MOTION/schedule" pipelined
    hover 600 20
    press_all space
    wait_for '^motion.frames=32$' 120
    shoot motion
    stop_window
}
small_paper() {
    open ball:9000
    press_all shift+y
    click_on "PAPER/quick"
    wait_for '^paper.complete=true$' 280
    click_on "PAPER/figure-13"
    hover 600 20
    shoot paper
    stop_window
}
small_divergence() {
    open ball:9000 --traversal restart
    press_all d shift+d
    wait_for '^widths.points=7$' 120
    wait_for '^widths.outdated=false$' 120
    hover 600 20
    shoot divergence-widths
    stop_window
}
small_predicted() {
    open ball:9000
    press_all shift+p
    wait_for '^visits.outdated=false$' 120
    press_all h s
    click_on "VIEW/split lines"
    choose "VIEW/split colours" ratio
    wait_for '^cells.counted=[1-9]' 120
    hover 600 20
    shoot predicted
    stop_window
}
small_error() {
    open rooms
    press_all e
    click_on "ERROR/sample"
    wait_for '^convergence.curves.independent, stack, cpu.points=9$' 280
    press_all t
    wait_for '^convergence.curves.independent, restart, cpu.points=9$' 280
    click_on "ERROR/stop"
    hover 600 20
    shoot error-time
    stop_window
}
small_splits() {
    open ball:9000
    press_all shift+s
    click_on "SPLITS/root"
    click_on "SPLITS/below"
    click_on "SPLITS/above"
    wait_for '^splits.costs.path=ba$'
    drag_slider "SPLITS/across x" 0.3 0.43
    wait_for '^splits.without.interior='
    wait_for '^splits.now.interior='
    hover 600 20
    shoot splits-explorer
    stop_window
}
small_nodes() {
    open ball:9000
    press_all i
    hover 270 190
    press p
    wait_for '^selected.leaf=true$'
    choose "NODES/colours" visits
    wait_for '^nodes.coloured=true$' 120
    click_on "NODES/y"
    click_on "NODES/hit"
    hover 600 20
    shoot nodes
    stop_window
}
small_oracle() {
    open rooms --rules as-published
    click_on "top/Oracle"
    wait_for '^oracle.wrong=[1-9]'
    press_all w w w
    shoot oracle
    stop_window
}

panels_of_scene() {
    open scatter:10000
    drag_slider "SCENE/seed" 0.05 0.2
    shoot panel-scene 3
    stop_window
}
panels_of_tree() {
    open ball:9000
    open_or_close "TREE/more constants"
    drag_slider "TREE/empty bonus (b_e)" 0.22 0.8
    press_all s bracketright bracketright
    point_at "TREE/empty bonus (b_e)" 0.8
    shoot panel-tree 3
    open_or_close "TREE/default" "TREE/more constants"

    press_all s v
    open_or_close "TREE/statistics" "TRACING/passes and rules"
    choose "TRACING/early z" "as published"
    point_at "TRACING/early z"
    shoot panel-tracing 4
    choose "TRACING/early z" working
    open_or_close "TRACING/passes and rules"
    press_all v
    sleep 3

    choose "top/map" triangles
    press_all s g c l
    open_or_close "VIEW/split lines"
    point_at "VIEW/range"
    shoot panel-view 3
    choose "VIEW/colours" viridis
    choose "top/map" nodes
    press_all n g bracketleft bracketleft bracketleft

    hover 520 560
    sleep 0.5
    xdotool click 1
    sleep 0.5
    press_all Right Right period period period period
    shoot panel-pixel 3

    press_all Escape s
    click_on "EXPORT/figure"
    wait_for '^last_export=.*png$'
    click_on "EXPORT/CSV"
    wait_for '^last_export=.*csv$'
    shoot panel-export
    stop_window
}
panels_of_time() {
    open ball:9000 --traversal restart
    sleep 3
    decided
    xdotool mousemove 340 860
    shoot panel-time
    stop_window
}

if [[ $SCREEN == 1280x720 ]]; then
    all="small_tour small_stability small_needs small_paper small_divergence small_error small_splits small_nodes small_predicted small_oracle small_motion"
else
    all="panels_of_scene panels_of_tree panels_of_time"
fi
for part in $all; do
    [[ -z $parts || " $parts " == *" $part "* ]] && $part
done
exit 0
