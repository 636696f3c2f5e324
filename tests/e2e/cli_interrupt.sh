#!/usr/bin/env bash
# C12, Ctrl-C during long work: exit code 130 soon, one line, no file and no temporary file left.
set -u
rm -rf work && mkdir work && cd work || exit 1

# interrupt SECONDS ARGUMENTS...: within so many it has ended.
interrupt() {
    local most=$1
    shift
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
    if ((SECONDS > most * ${KD_PATIENCE:-1})); then
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

interrupt 30 render scatter:300000 -o picture.png --size 2048x2048 --json picture.json
interrupt 30 verify scatter:200000 --tracer cpu
interrupt 30 bench scatter:5000 --tracer cpu --size 2048x2048 --rounds 1000
interrupt 30 stability --case T02,T24 --long --tracer cpu
# Amid a build of a million triangles, 0.05 to 0.09 s where it was measured.
interrupt 2 bench ball:1000000 --builder exact --tracer cpu
echo "passed"
