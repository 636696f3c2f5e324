#!/usr/bin/env bash
# C12, Ctrl-C during long work: exit code 130 soon, one line, no file and no temporary file left.
set -u
rm -rf work && mkdir work && cd work || exit 1

interrupt() {
    "$KDSCOPE" "$@" >out.txt 2>err.txt &
    local pid=$!
    sleep 1
    kill -INT "$pid"
    SECONDS=0
    wait "$pid"
    local code=$?
    if [[ $code -ne 130 ]]; then
        echo "FAIL: exit code $code instead of 130: $*"
        cat out.txt err.txt
        exit 1
    fi
    if ((SECONDS > 30 * ${KD_PATIENCE:-1})); then
        echo "FAIL: it took $SECONDS s to end: $*"
        exit 1
    fi
    if [[ $(cat err.txt) != "kdscope: interrupted" ]]; then
        echo "FAIL: standard error holds: $(cat err.txt)"
        exit 1
    fi
    rm out.txt err.txt
    if [[ -n $(ls -A) ]]; then
        echo "FAIL: left behind: $(ls -A)"
        exit 1
    fi
}

interrupt render scatter:300000 -o picture.png --size 2048x2048 --json picture.json
interrupt verify scatter:200000 --tracer cpu
interrupt bench scatter:5000 --tracer cpu --size 2048x2048 --rounds 1000
interrupt stability --case T02,T24 --long --tracer cpu
echo "passed"
