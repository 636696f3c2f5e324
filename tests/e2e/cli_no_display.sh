#!/usr/bin/env bash
# Without a display the window says so, names the way out, and exit code 3 tells scripts.
set -u
unset DISPLAY WAYLAND_DISPLAY
for arguments in "" "view" "ball:100" "view cornell --traversal restart"; do
    # shellcheck disable=SC2086
    message=$("$KDSCOPE" $arguments 2>&1 >/dev/null)
    code=$?
    if [[ $code -ne 3 || $message != *"kdscope render"* || $message == *$'\n'* ]]; then
        echo "FAIL: kdscope $arguments: exit code $code: $message"
        exit 1
    fi
done
# With an address that leads nowhere it is the same, if this build has a window at all.
message=$(DISPLAY=:987 "$KDSCOPE" 2>&1 >/dev/null)
code=$?
if [[ $code -ne 3 || $message != *"kdscope render"* ]]; then
    echo "FAIL: DISPLAY=:987: exit code $code: $message"
    exit 1
fi
echo "passed"
