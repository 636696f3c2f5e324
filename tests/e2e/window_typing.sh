#!/usr/bin/env bash
# Text that is typed faster than frames are drawn arrives whole and in order, and none of it is taken for commands.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window ball:300
click_on "EXPORT/folder"
xdotool key ctrl+a
xdotool type --delay 0 "/tmp/a-folder-nobody-has/with/a-long-name"
wait_for '^window.folder=/tmp/a-folder-nobody-has/with/a-long-name$' 20
# Not within one millisecond: GLFW takes such presses of one key for duplicates that input methods send.
xdotool key --delay 8 BackSpace BackSpace BackSpace BackSpace BackSpace x y BackSpace Left Left Z End q
wait_for "^window.folder=/tmp/a-folder-nobody-has/with/a-lonZgxq$" 20
[[ $(value settings.traversal) == stack && $(value settings.view.map.shown) == true ]] || fail "letters of the text were taken for keys"

# A click and what is typed behind it: the letters are for the field; after Enter they are keys again.
press Return
point_at "TREE/leaf size"
xdotool keydown ctrl click 1 keyup ctrl type --delay 0 "17"
xdotool key --delay 0 Return t
wait_for '^settings.build.leaf_size=17$' 20
wait_for '^settings.traversal=restart$' 20
echo "passed"
