#!/usr/bin/env bash
# Without OpenGL 4.3 the window opens all the same: the CPU traces, and one line says why. Without a display it does not.
source "$(dirname -- "${BASH_SOURCE[0]}")/window_helpers.bash"

export MESA_GL_VERSION_OVERRIDE=3.3
start_window ball:300 --tracer gl-fragment
wait_for '^settings.tracer=cpu$'
wait_for '^messages.0.error=true$'
[[ $(value messages.0.text) == *OpenGL\ 4.3* ]] || fail "the line does not say why: $(value messages.0.text)"
wait_for '^gpu.unavailable=.'
press v
[[ $(value settings.tracer) == cpu ]] || fail "V changed to a GPU that is not there"
stop_window

# Less than the window itself is drawn with. What the driver leaks when it gives up is its own, in a library that is no
# longer loaded when leaks are told.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
MESA_GL_VERSION_OVERRIDE=2.1 MESA_GLSL_VERSION_OVERRIDE=120 "$KDSCOPE" ball:300 >out.txt 2>err.txt
code=$?
[[ $code -eq 3 ]] || fail "exit code $code with OpenGL 2.1: $(cat err.txt)"
[[ $(wc -l <err.txt) -eq 1 ]] || fail "not one line: $(cat err.txt)"
grep -q 'kdscope render' err.txt || fail "no way out is named: $(cat err.txt)"

DISPLAY=:987 "$KDSCOPE" ball:300 >out.txt 2>err.txt
code=$?
[[ $code -eq 3 ]] || fail "exit code $code without a display"
[[ $(wc -l <err.txt) -eq 1 ]] || fail "not one line: $(cat err.txt)"
echo "passed"
