# What the tests of the window share: a virtual screen, the window in it, its state file. Sourced first by every window_*.sh.

SCREEN=${SCREEN:-1280x720}
PATIENCE=${KD_PATIENCE:-1}  # times as long is waited; sanitizers make everything slower

skip() {
    echo "SKIPPED: $*"
    exit 77
}

if [[ -z ${KD_INSIDE_XVFB:-} ]]; then
    for tool in xvfb-run xdotool import convert; do
        command -v "$tool" >/dev/null || skip "$tool is not installed"
    done
    DISPLAY='' WAYLAND_DISPLAY='' "$KDSCOPE" view 2>&1 | grep -q 'this build has no window' && skip "this build has no window"
    export KD_INSIDE_XVFB=1 SCREEN
    exec xvfb-run -a -s "-screen 0 ${SCREEN}x24" bash "$0" "$@"
fi

rm -rf work && mkdir work && cd work || exit 1
export KDSCOPE_STATE_FILE=$PWD/state.json
export XDG_CONFIG_HOME=$PWD/config
export KDSCOPE_EXIT_AFTER_S=$((PATIENCE > 1 ? 1700 : 900))
window_pid=

fail() {
    echo "FAIL: $*"
    [[ -f log.txt ]] && cat log.txt
    [[ -f $KDSCOPE_STATE_FILE ]] && state >state.txt && cat state.txt
    exit 1
}

stop_window() {
    [[ -n $window_pid ]] && kill "$window_pid" 2>/dev/null && wait "$window_pid" 2>/dev/null
    window_pid=
}
trap stop_window EXIT

# The state file as lines path=value, such as frame.scale=1 or picture_area.0=252.0.
state() {
    awk '
        function join(   i, p) { p = path[1]; for (i = 2; i <= depth; i++) p = p "." path[i]; return p }
        {
            line = $0; sub(/^ +/, "", line); sub(/,$/, "", line)
            if (line == "}" || line == "]") { depth--; next }
            if (line == "{" && NR == 1) next
            if (match(line, /^"[^"]*": /)) { key = substr(line, 2, RLENGTH - 4); value = substr(line, RLENGTH + 1) }
            else { key = count[depth]++; value = line }
            path[++depth] = key
            if (value == "{" || value == "[") { count[depth] = 0; next }
            gsub(/^"|"$/, "", value)
            print join() "=" value
            depth--
        }' "$KDSCOPE_STATE_FILE"
}

# The value at a path; empty where there is none.
value() { state | sed -n "s/^${1//./\\.}=//p"; }

# Waits until the state has a line that matches the regular expression: wait_for '^frame.scale=1$' [seconds].
wait_for() {
    local end=$((SECONDS + PATIENCE * ${2:-60}))
    until [[ -f $KDSCOPE_STATE_FILE ]] && state | grep -qE "$1"; do
        kill -0 "$window_pid" 2>/dev/null || fail "the window is gone, waiting for $1"
        ((SECONDS < end)) || fail "not reached: $1"
        sleep 0.1
    done
}

# Waits until the screen answers COUNT more inputs of a KIND than the number BEFORE: answered KIND BEFORE COUNT.
answered() {
    local end=$((SECONDS + PATIENCE * 60))
    until (($(inputs "$1") >= $2 + $3)); do
        kill -0 "$window_pid" 2>/dev/null || fail "the window is gone"
        ((SECONDS < end)) || fail "$(inputs "$1") inputs of kind '$1' are answered, not $(($2 + $3))"
        sleep 0.05
    done
}
inputs() {
    local count
    count=$(value "inputs.$1")
    echo "${count:-0}"
}

# Opens the window and waits for the first whole picture.
start_window() {
    rm -f "$KDSCOPE_STATE_FILE"
    "$KDSCOPE" "$@" >log.txt 2>&1 &
    window_pid=$!
    wait_for '^frame.scale=1$'
    window=$(xdotool search --name '^kdscope$' | tail -1)
    xdotool windowmove "$window" 0 0 windowfocus "$window" 2>/dev/null

}

# Presses a key, such as t or ctrl+c, and waits for the picture after it.
press() {
    local before parts=${1//[^+]/}
    before=$(inputs key)
    xdotool key "$1"
    answered key "$before" $((2 * (1 + ${#parts})))
}

# Moves the mouse to a place of the screen.
move_to() {
    local before X Y
    eval "$(xdotool getmouselocation --shell | grep '^[XY]=')"
    [[ $X == "$1" && $Y == "$2" ]] && return
    before=$(inputs move)
    xdotool mousemove "$1" "$2"
    answered move "$before" 1
}
# Moves it by steps: move_by STEPS X Y.
move_by() {
    local before
    for _ in $(seq "$1"); do
        before=$(inputs move)
        xdotool mousemove_relative -- "$2" "$3"
        answered move "$before" 1
    done
}

# Where a control stands, such as "TREE/leaf size": left, top, width, height. Nothing where it is not to be seen.
place() {
    state | awk -v path="places.$1." '
        index($0, path) == 1 { split(substr($0, length(path) + 1), part, "="); at[part[1]] = part[2] }
        END { if (3 in at) print at[0], at[1], at[2], at[3] }'
}

# Moves the mouse to a control, a share of its width from its left: point_at LABEL [share].
point_at() {
    local end=$((SECONDS + PATIENCE * 30)) x
    until [[ -f $KDSCOPE_STATE_FILE ]] && read -r -a x < <(place "$1"); do
        ((SECONDS < end)) || fail "there is no '$1' to be seen"
        sleep 0.1
    done
    move_to "$(awk "BEGIN { print int(${x[0]} + ${2:-0.5} * ${x[2]}) }")" "$(awk "BEGIN { print int(${x[1]} + 0.5 * ${x[3]}) }")"
}

# The window looks at the mouse once per frame, so each change waits for its own.
button() {
    local before
    before=$(inputs button)
    xdotool "$1" "${2:-1}"
    answered button "$before" 1
}
hold() { button mousedown "$@"; }
let_go() { button mouseup "$@"; }

click_on() { point_at "$1" && hold && let_go; }

# Opens a list and chooses a line of it: choose "top/scene" rooms.
choose() { click_on "$1" && click_on "$1/$2"; }

# Drags a slider's grab from one share of its width to another.
drag_slider() {
    point_at "$1" "$2" && hold && point_at "$1" "$3" && let_go
}

# Moves the mouse to a pixel of the picture.
hover() {
    local left top
    left=$(value picture_area.0)
    top=$(value picture_area.1)
    move_to $((${left%.*} + $1)) $((${top%.*} + $2))
}

# Writes what is seen of the picture, without the legend's corner at the right, as a PNG file.
see_picture() {
    local left top width height
    left=$(value picture_area.0) top=$(value picture_area.1)
    width=$(value picture_area.2) height=$(value picture_area.3)
    sleep 0.3  # the state file may be one frame ahead of the screen
    import -window root -crop "$((${width%.*} - 260))x${height%.*}+${left%.*}+${top%.*}" +repage "$1"
}

# Mean difference of two images of one size, 0..1.
difference() { compare -metric MAE "$1" "$2" null: 2>&1 | sed 's/.*(\(.*\)).*/\1/'; }

# True where the number expression holds.
holds() { awk "BEGIN { exit !($1) }"; }
