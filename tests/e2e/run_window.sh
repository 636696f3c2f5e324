#!/usr/bin/env bash
# ./run with a display opens the window, from any folder, and hands its arguments on.
# Only the release build has this test, for ./run brings that build up to date.
export KDSCOPE=$KD_SOURCE_DIR/run
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

start_window
wait_for '^scene.name=ball:9000$'
see_picture first.png
stop_window

start_window rooms --traversal restart
wait_for '^scene.name=rooms$'
wait_for '^settings.traversal=restart$'
stop_window
echo "passed"
