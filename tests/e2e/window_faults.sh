#!/usr/bin/env bash
# Faults of docs/stability.md as the window meets them: it stays, shows a picture and says what happened.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

says() { wait_for "^messages\.[0-9]+\.text=.*$1" 120; }

# F09: sizes that nobody would choose, and a storm of them.
start_window ball:300
before=$(value generation)
sizes=()
for i in $(seq 1000); do sizes+=(windowsize "$window" $((700 + i % 300)) $((500 + i % 200))); done
xdotool "${sizes[@]}"
xdotool windowsize --sync "$window" 1 1
xdotool windowsize --sync "$window" 16000 1
xdotool windowsize --sync "$window" 900 650
wait_for '^inputs.resize=[1-9]'
xdotool windowsize "$window" 1280 720
wait_for '^picture_area.2=[0-9.]*$'
width=$(value picture_area.2)
wait_for "^frame.width=${width%.*}$"
after=$(value generation)
((after - before < 500)) || fail "F09: $((after - before)) pictures were asked for"

# F10: nothing is drawn or timed while nobody can see it.
busy() { awk '{ print $14 + $15 }' "/proc/$window_pid/stat"; }  # hundredths of a second
work_of_4s() {
    local before
    before=$(busy)
    sleep 4
    echo $(($(busy) - before))
}
wait_for '^duel.rounds=[1-9]'
seen=$(work_of_4s)
xdotool windowunmap --sync "$window"
sleep 2
unseen=$(work_of_4s)
((unseen < 60 && 2 * unseen < seen)) || fail "F10: $unseen hundredths of a second of work out of sight, $seen in sight"
xdotool windowmap --sync "$window"
see_picture seen.png
[[ $(convert seen.png -format '%k' info:) -gt 100 ]] || fail "F10: nothing to be seen afterwards"

# F12: a folder that takes no file; the window goes on.
click_on "EXPORT/folder"
xdotool keydown ctrl keydown a && sleep 0.15 && xdotool keyup a keyup ctrl
xdotool type --delay 30 '/proc'
press Return
for what in picture window CSV; do
    click_on "EXPORT/$what"
    says 'cannot write /proc/kdscope-1.*(No such file|Permission|not permitted)'
    press Escape
done

# F13: nothing in the clipboard, or no camera.
hover 30 30
press ctrl+v
says 'the text is no camera'
press t
wait_for '^settings.traversal=restart$'
stop_window

# F13: fonts that are none.
mkdir fonts
head -c 5000 /dev/urandom >fonts/DejaVuSans.ttf
: >fonts/DejaVuSans-Bold.ttf
KDSCOPE_FONTS=$PWD/fonts start_window ball:300
stop_window

# F18: the picture is made from the float frame, so what the window's own pixels are does not matter.
start_window ball:300
mkdir -p home
click_on "EXPORT/folder"
xdotool keydown ctrl keydown a && sleep 0.15 && xdotool keyup a keyup ctrl
xdotool type --delay 30 "$PWD/home"
press Return
click_on "EXPORT/picture"
wait_for '^last_export=.*kdscope-1.png$'
"$KDSCOPE" render ball:300 --size "$(value frame.width)x$(value frame.height)" --map nodes --opacity 0.5 --no-legend -o r.png >/dev/null ||
    fail "F18: render"
[[ $(compare -metric AE r.png home/kdscope-1.png null: 2>&1) == 0 ]] || fail "F18: the window's picture is another"
stop_window

# F03, F04, F08: what OpenGL does wrong is told, and the CPU goes on.
start_window ball:300
wait_for '^gpu.(renderer=.|unavailable=.)'
[[ -z $(value gpu.unavailable) ]] || { echo "all but F03, F04, F08 passed; no OpenGL 4.3 here: $(value gpu.unavailable)" && exit 77; }
stop_window
cp -r "$KD_SOURCE_DIR/shaders" broken
sed -i '5i nonsense' broken/fragment/rt_prim.frag
KD_SHADER_DIR=$PWD/broken start_window ball:300 --tracer gl-fragment
says 'shaders/fragment/rt_prim.frag:'
wait_for '^settings.tracer=cpu$'
stop_window
cp -r "$KD_SOURCE_DIR/shaders" fast
sed -i 's/return !(IS_NAN(a.x).*/return !(abs(a.x) > limit) \&\& !(abs(a.y) > limit) \&\& !(abs(a.z) > limit);/' fast/shared/ray.glsl
KD_SHADER_DIR=$PWD/fast start_window ball:300
says 'fails the self-test'
wait_for '^gpu.unavailable=.*self-test'
see_picture banner.png
stop_window
KDSCOPE_FAULT=lost:1 start_window ball:300 --tracer gl-fragment
for key in t t t; do press $key; done
says 'its context was made anew'
[[ $(value settings.tracer) == gl-fragment ]] || fail "F08: one loss is enough"
stop_window

echo "passed"
